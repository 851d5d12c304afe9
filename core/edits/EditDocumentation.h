// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <vector>

namespace core {

/// One field of an edit, in words.
struct FieldDocumentation {
    QString name; ///< with its group: "view.eyeLps"
    QString type;
    QString unit; ///< empty: none
    QString fallback; ///< JSON of what a missing field means; empty: required
    QString meaning;
};

struct EditDocumentation {
    QString name; ///< as in "edit": "drill"
    QString meaning;
    std::vector<FieldDocumentation> fields;
};

/// Every edit with its fields, generated from the schema that parses them (schema/SchemaParts.h).
[[nodiscard]] std::vector<EditDocumentation> editDocumentation();

} // namespace core
