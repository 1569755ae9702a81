// Figures: each is a design, report/figures/*.template.json, with the rows of its table as data.
#pragma once

#include <vector>

#include "cases/io/new_files.h"
#include "report/text/document.h"

namespace desmo::report {

/// Returns the Vega-Lite specification NAME.vl.json of every table that is the data of a figure.
///
/// A datum is a row. A column of text gives a value under its name. A column of numbers "c" gives
/// - "c": its first quantity, and "c <quantity>": each other one that is known
/// - "c shown": Entry::shown, and "c note": Entry::note, if there is one
/// The data set "lines" has the table's lines. Keys that a design does not mention are left out.
/// `usermeta` of a design may have
/// - fold: a key. A datum is then an entry with numbers: its column's name stands under that key,
///   its quantities under their own names, with "shown" and "note".
/// - number: a column. The second panel shows the rows without a number there; it is left out where
///   all rows have one.
///
/// The boxes below a figure show the names of its first scale with a range. A scale keeps the names
/// that were measured, each with its colour or shape. Names that its design does not list are grey
/// crosses. A scale with a named range takes all names.
std::vector<NewFile> figures(const Document& document);

}  // namespace desmo::report
