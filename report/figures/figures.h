// Figures: each fills a design, report/figures/*.template.json, with the rows of its table.
#pragma once

#include <vector>

#include "cases/io/new_files.h"
#include "report/text/document.h"

namespace desmo::report {

/// Returns the Vega-Lite specification NAME.vl.json of every table that is the data of a figure.
///
/// A datum is a row. Columns of text stand under their name; a column of numbers "c" gives "c", its
/// first quantity, "c <quantity>" for the others, and "c shown", the text of the hover. A design
/// whose `usermeta.fold` names a key has a datum for each number instead: the column's name under
/// that key, the quantities under their own names, "shown" and "note". The set of data "lines" has
/// the table's lines. The second panel of a design whose `usermeta.number` names a column shows
/// rows without that number, and is left out where there is none. Scales keep what the data have,
/// with its colour and shape; what a design does not know is a grey cross.
std::vector<NewFile> figures(const Document& document);

}  // namespace desmo::report
