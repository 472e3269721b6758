#pragma once

#include <string>
#include <string_view>

namespace ricochet {

/// A name or message as a label in tables for other programs. pandas.read_csv, pandas.read_json and
/// R take some texts for a missing value, even in quotes: "nan", the name of a perturbation,
/// becomes "missing-value", and the others, such as "NA", "null" and "None", get a ' before them.
/// An empty text stays empty: it is a missing value.
std::string label(std::string_view text);

}  // namespace ricochet
