// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/edits/fields/EditFields.h"
#include "core/edits/kinds/parts/DrawnPlane.h"

#include <vector>

namespace core::editFields {

/// A list of planes in JSON: [{"placeLps": [x, y, z], "normalLps": [x, y, z]}, …], with at least
/// two entries; type as in EditFields.h.
struct DrawnPlaneList {
    using Value = std::vector<DrawnPlane>;
    Point place;
    Point normal;

    [[nodiscard]] QString type() const { return QStringLiteral("[{placeLps, normalLps}, …]"); }
    [[nodiscard]] QString unit() const { return QStringLiteral("mm, direction"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const;
};

} // namespace core::editFields
