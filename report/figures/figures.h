// Figures: each fills a design, report/figures/*.template.json, with the rows of its table.
#pragma once

#include <vector>

#include "cases/io/new_files.h"
#include "report/text/document.h"

namespace desmo::report {

/// Returns the Vega-Lite specification NAME.vl.json of every table that is the data of a figure.
///
/// A datum is a row. Columns of text stand under their name; a column of numbers "c" gives "c", its
/// first quantity, "c <quantity>" for the others, and "c shown", the text of the hover. The set of
/// data "lines" has the table's lines. What a design does not mention is left out. `usermeta` of a
/// design may have
/// - fold: a key. A datum is a number instead: its column's name under that key, its quantities
///   under their own names, "shown" and "note".
/// - number: a column. The second panel shows rows without that number, if there are any.
///
/// The boxes below a figure and its legend show the names of its first scale that has some. A scale
/// keeps what was measured, each with its colour and shape; what it does not know is a grey cross.
/// A scale with a named range takes all names.
std::vector<NewFile> figures(const Document& document);

}  // namespace desmo::report
