// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/edits/fields/EditFields.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/edits/kinds/parts/PenSample.h"

#include <cstdint>
#include <vector>

namespace core::editFields {

// Fields that contain lists; types as in EditFields.h.

/// [[x, y, z], …], at least one.
struct PointList {
    using Value = std::vector<glm::dvec3>;
    Point point;
    bool mayBeEmpty = false;

    [[nodiscard]] QString type() const { return QStringLiteral("[[x, y, z], …]"); }
    [[nodiscard]] QString unit() const { return point.unit(); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const;
};

/// [[[x, y, z], …], …], at least one list, each of three points or more.
struct ContourList {
    using Value = std::vector<std::vector<glm::dvec3>>;
    Point point;

    [[nodiscard]] QString type() const { return QStringLiteral("[[[x, y, z], …], …]"); }
    [[nodiscard]] QString unit() const { return point.unit(); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const;
};

/// [[x, y], …], at least three points, or as many as it needs.
struct Outline {
    using Value = std::vector<glm::dvec2>;
    Number component;
    std::size_t fewest = 3;

    [[nodiscard]] QString type() const { return QStringLiteral("[[x, y], …]"); }
    [[nodiscard]] QString unit() const { return component.unit(); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const;
};

/// [[x, y, z, offset], …]: half-spaces, 1 to 16 of them.
struct ClipHalfSpaceList {
    using Value = std::vector<ClipHalfSpace>;

    [[nodiscard]] QString type() const { return QStringLiteral("[[x, y, z, offset], …]"); }
    [[nodiscard]] QString unit() const { return QStringLiteral("direction, mm"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const;
};

/// [[x, y, pressure, t], …], at least one; t never decreases.
struct SampleList {
    using Value = std::vector<PenSample>;

    [[nodiscard]] QString type() const { return QStringLiteral("[[x, y, pressure, t], …]"); }
    [[nodiscard]] QString unit() const { return QStringLiteral("mm, mm, 0 … 1, s"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const;
};

/// A list of pen pressures in JSON: [pressure, …], each 0 … 1, with at least one entry.
struct PressureList {
    using Value = std::vector<double>;

    [[nodiscard]] QString type() const { return QStringLiteral("[pressure, …]"); }
    [[nodiscard]] QString unit() const { return QStringLiteral("0 … 1"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const;
};

/// [row, …]: rows of the history, at least one, ascending.
struct RowList : PlainField<std::vector<std::int64_t>> {
    [[nodiscard]] QString type() const { return QStringLiteral("[row, …]"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

/// [place, …]: places in another list, from 1, ascending; may be empty.
struct PlaceList : PlainField<std::vector<std::int64_t>> {
    [[nodiscard]] QString type() const { return QStringLiteral("[place, …]"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

/// [[x, y, z], [x, y, z]]: opposite corners of a box.
struct CornerPair {
    using Value = GrowBox;
    Point point;

    [[nodiscard]] QString type() const { return QStringLiteral("[[x, y, z], [x, y, z]]"); }
    [[nodiscard]] QString unit() const { return point.unit(); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const;
};

/// A list of segments in JSON: [segment, …], labels in ascending order, with at least one entry
/// unless it may be empty.
struct SegmentList {
    using Value = std::vector<int>;
    bool mayBeEmpty = false;

    [[nodiscard]] QString type() const { return QStringLiteral("[segment, …]"); }
    [[nodiscard]] QString unit() const { return {}; }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const { return value; }
};

} // namespace core::editFields
