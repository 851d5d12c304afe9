// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/edits/fields/EditFields.h"
#include "core/edits/kinds/chunks/DivideSegment.h"

#include <cstdint>
#include <vector>

namespace core::editFields {

// Fields of the edits that divide into chunks and add or remove them; types as in EditFields.h.

/// [{"label", "voxels"}, …], at least one, labels ascending; voxels in base 64.
struct ChunkOwnerList : PlainField<std::vector<ChunkOwner>> {
    [[nodiscard]] QString type() const { return QStringLiteral("[{label, voxels}, …]"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

/// Bytes in base 64; not empty.
struct PackedBytes : PlainField<QByteArray> {
    [[nodiscard]] QString type() const { return QStringLiteral("text"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

/// [brick, …]: numbers of bricks of the volume, from 0, ascending; may be empty.
struct BrickList : PlainField<std::vector<std::int64_t>> {
    [[nodiscard]] QString type() const { return QStringLiteral("[brick, …]"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

} // namespace core::editFields
