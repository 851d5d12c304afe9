// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <vector>

namespace core {

/// The documentation of one field of an edit.
struct FieldDocumentation {
    QString name; ///< with its group: "view.eyeLps"
    QString type;
    QString unit; ///< empty: none
    QString fallback; ///< JSON of the default; empty: the field is required
    QString meaning;
};

struct EditDocumentation {
    QString name; ///< as in "edit": "drill"
    QString meaning;
    std::vector<FieldDocumentation> fields;
};

/// All edits with their fields, generated from the schema that parses them (schema/SchemaParts.h).
[[nodiscard]] std::vector<EditDocumentation> editDocumentation();

} // namespace core
