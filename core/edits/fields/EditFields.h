// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/document/Document.h"

#include <QJsonValue>
#include <QString>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace core::editFields {

// The types that a field of an edit can have. Each one defines one JSON form, one range and one
// rounding:
//
//   type(), unit()   for the documentation
//   write(value)     the JSON form
//   read(json, out)  empty on success, else the reason ("must be a number")
//   check(value)     empty if the value is allowed, else the reason
//   rounded(value)   the nearest value of the field's grid; idempotent (EditQuantise.h)

/// The base of those whose values have no unit and no grid.
template <class V> struct PlainField {
    using Value = V;

    [[nodiscard]] QString unit() const { return {}; }
    [[nodiscard]] Value rounded(const Value& value) const { return value; }
};

/// A number; NaN and infinities are never allowed.
struct Number {
    using Value = double;
    const char* unitName = "";
    double minimum = 0.0;
    double maximum = 0.0;
    double stepsPerUnit = 0.0; ///< values are multiples of 1 / stepsPerUnit; 0: kept exactly

    [[nodiscard]] QString type() const;
    [[nodiscard]] QString unit() const;
    [[nodiscard]] QJsonValue write(Value value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(Value value) const;
    [[nodiscard]] Value rounded(Value value) const;
};

struct WholeNumber {
    using Value = int;
    int minimum = 0;
    int maximum = 0;

    [[nodiscard]] QString type() const;
    [[nodiscard]] QString unit() const { return {}; }
    [[nodiscard]] QJsonValue write(Value value) const { return value; }
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(Value value) const;
    [[nodiscard]] Value rounded(Value value) const { return value; }
};

/// The number by which an edit refers to an object of the document. If the edit is carried out on
/// another study, the object may have another number there (core/recipe/RecipeElsewhere.h).
struct ThingNumber : WholeNumber {
    enum class Thing { Segment, Layer, Piece, Bookmark, Measurement };
    Thing thing = Thing::Segment;
};

/// The number of neighbours of a voxel.
struct Connectivity : PlainField<int> {
    [[nodiscard]] QString type() const { return QStringLiteral("6, 18 or 26"); }
    [[nodiscard]] QJsonValue write(Value value) const { return value; }
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(Value value) const;
};

struct Flag : PlainField<bool> {
    [[nodiscard]] QString type() const { return QStringLiteral("true or false"); }
    [[nodiscard]] QJsonValue write(Value value) const { return value; }
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(Value) const { return {}; }
};

/// A name: 1 to 256 characters of valid Unicode without control characters.
struct Text : PlainField<QString> {
    [[nodiscard]] QString type() const { return QStringLiteral("text"); }
    [[nodiscard]] QJsonValue write(const Value& value) const { return value; }
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

/// "#rrggbb".
struct Colour : PlainField<std::uint32_t> {
    [[nodiscard]] QString type() const { return QStringLiteral("\"#rrggbb\""); }
    [[nodiscard]] QJsonValue write(Value value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(Value value) const;
};

/// [scheme, value, meaning]; [] is "not coded yet".
struct Code : PlainField<CodedConcept> {
    [[nodiscard]] QString type() const { return QStringLiteral("[scheme, value, meaning]"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
};

/// Reads exactly @p count numbers from a JSON list; returns empty on success, else the reason.
[[nodiscard]] Clause readNumbers(const QJsonValue& json, double* numbers, int count);

/// [x, y, z]; the same rule applies to each number.
struct Point {
    using Value = glm::dvec3;
    Number component;

    [[nodiscard]] QString type() const { return QStringLiteral("[x, y, z]"); }
    [[nodiscard]] QString unit() const { return component.unit(); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const;
};

/// One of several names, in the order of the enumerators.
template <class E, std::size_t N> struct Choice {
    using Value = E;
    std::array<const char*, N> names{};

    [[nodiscard]] QString type() const
    {
        QString text;
        for (const char* name : names)
            text += (text.isEmpty() ? QStringLiteral("\"") : QStringLiteral(" or \""))
                + QLatin1String(name) + QLatin1Char('"');
        return text;
    }
    [[nodiscard]] QString unit() const { return {}; }
    [[nodiscard]] QJsonValue write(Value value) const
    {
        return QLatin1String(names[std::size_t(value)]);
    }
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const
    {
        const QString text = json.toString();
        for (std::size_t i = 0; i < N; ++i) {
            if (text == QLatin1String(names[i])) {
                value = E(i);
                return {};
            }
        }
        return Clause::saying("must be %1", type());
    }
    [[nodiscard]] Clause check(Value) const { return {}; }
    [[nodiscard]] Value rounded(Value value) const { return value; }
};

/// A row of the history.
struct Row : PlainField<std::int64_t> {
    [[nodiscard]] QString type() const { return QStringLiteral("row"); }
    [[nodiscard]] QJsonValue write(Value value) const { return qint64(value); }
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(Value value) const;
};

/// A count of growth steps, or "toClosure".
struct StepCount {
    using Value = std::optional<int>;
    const char* all = "toClosure"; ///< the word for no value

    [[nodiscard]] QString type() const;
    [[nodiscard]] QString unit() const { return QStringLiteral("steps"); }
    [[nodiscard]] QJsonValue write(const Value& value) const;
    [[nodiscard]] Clause read(const QJsonValue& json, Value& value) const;
    [[nodiscard]] Clause check(const Value& value) const;
    [[nodiscard]] Value rounded(const Value& value) const { return value; }
};

} // namespace core::editFields
