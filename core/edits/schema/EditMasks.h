// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/edits/fields/EditFields.h"
#include "core/edits/kinds/imports/ImportMask.h"

#include <vector>

namespace core::editFields {

// Fields of the edit that imports a mask; types as in EditFields.h.

/// The name of a file, with or without its folder.
struct FileName : PlainField<QString> {
    [[nodiscard]] QString type() const { return QStringLiteral("text"); }
    [[nodiscard]] QJsonValue write(const Value& value) const { return value; }
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

/// A segment by its number or by its name.
struct SegmentReference : PlainField<SegmentWord> {
    [[nodiscard]] QString type() const { return QStringLiteral("text, or whole number 1 … 255"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

/// [columns, rows, slices].
struct GridSize {
    using Value = glm::ivec3;

    [[nodiscard]] QString type() const { return QStringLiteral("[x, y, z]"); }
    [[nodiscard]] QString unit() const { return QStringLiteral("voxels"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const { return value; }
};

/// [{"name", "color", "code", "voxels"}, …], at least one; voxels in base 64.
struct ImportedSegmentList : PlainField<std::vector<ImportedSegment>> {
    [[nodiscard]] QString type() const
    {
        return QStringLiteral("[{name, color, code, voxels}, …]");
    }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

/// Places in another list in JSON: [place, …], from 1, in any order, none twice, with at least one
/// entry.
struct EntryOrder : PlainField<std::vector<int>> {
    [[nodiscard]] QString type() const { return QStringLiteral("[place, …]"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

/// The label plane of each segment of a list in JSON: [plane, …], from 0, with at least one entry.
struct PlaneList : PlainField<std::vector<int>> {
    [[nodiscard]] QString type() const { return QStringLiteral("[plane, …]"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

} // namespace core::editFields
