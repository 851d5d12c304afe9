// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/edits/fields/EditFields.h"
#include "core/edits/kinds/splitting/SplitParts.h"

#include <vector>

namespace core::editFields {

// Fields of edits that split segments; types as in EditFields.h.

/// A list of new segments in JSON: [{"name", "color"}, …], with at least one entry.
struct SplitPartList : PlainField<std::vector<SplitPart>> {
    [[nodiscard]] QString type() const { return QStringLiteral("[{name, color}, …]"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

} // namespace core::editFields
