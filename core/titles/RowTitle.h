// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/titles/RowTitleCode.h"

#include <QString>

#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace core {

// A row's title: what it says to people, as a code with arguments. The name that a session file
// keeps of a row is made from it here, in English; the window words it in its own language
// (ui/base/RowTitleText.h). No argument is a sentence.

struct RowTitle;

/// How many of something: 18204 is written "18 204". As the first argument it selects the singular
/// or plural form.
struct TitleCount {
    std::int64_t count = 0;
    bool operator==(const TitleCount&) const = default;
};
/// A whole number that counts nothing: a place in a list, a number of an object, degrees.
struct TitleNumber {
    std::int64_t number = 0;
    bool operator==(const TitleNumber&) const = default;
};
/// A number that is written with a fixed number of decimals: millimetres have one.
struct TitleDecimal {
    double value = 0.0;
    int decimals = 1;
    bool operator==(const TitleDecimal&) const = default;
};
/// A number that is written with a number of significant digits: grey values, factors.
struct TitleDigits {
    double value = 0.0;
    int digits = 6;
    bool operator==(const TitleDigits&) const = default;
};
/// A text is a name that a user gave, the name of a file, the meaning of a code, or a unit. A list
/// of titles is the quoted title of another row, parts that are joined (reasons, changes), or a
/// word that several titles use.
using TitleArgument = std::variant<TitleCount, TitleNumber, TitleDecimal, TitleDigits, QString,
    std::vector<RowTitle>>;

struct RowTitle {
    RowTitleCode code = RowTitleCode::Nothing;
    std::vector<TitleArgument> arguments{};
    /// Further parts, each written after a comma. For a step that changes voxels or the surface,
    /// the last part says how much it changed; otherwise they say what else was done.
    std::vector<RowTitle> then{};
    bool operator==(const RowTitle& other) const; // not defaulted, because titles contain titles
};

[[nodiscard]] inline TitleDecimal inMm(double mm)
{
    return {.value = mm, .decimals = 1};
}

/// A title as an argument of another one.
[[nodiscard]] inline TitleArgument asArgument(RowTitle title)
{
    return std::vector<RowTitle>{std::move(title)};
}

/// The name of a row as it is stored and covered by the hash chain. It must never change for a
/// given title.
[[nodiscard]] QString canonicalName(const RowTitle& title);

/// The title without its last part, as other rows quote it: "Drill 6.2 mm" of "Drill 6.2 mm, 214
/// bricks".
[[nodiscard]] RowTitle headlineOf(RowTitle title);

/// The depth to which titles are nested; 1: the title contains no other.
[[nodiscard]] int depthOf(const RowTitle& title);

} // namespace core
