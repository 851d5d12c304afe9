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

/// How many of something: 18204 is written "18 204". As the first argument it decides between one
/// and many.
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
/// A text is what a user named, a file's name, a code's meaning or a unit. Titles are quoted (of
/// another row), joined (reasons, changes), or a word that is used in several.
using TitleArgument = std::variant<TitleCount, TitleNumber, TitleDecimal, TitleDigits, QString,
    std::vector<RowTitle>>;

struct RowTitle {
    RowTitleCode code = RowTitleCode::Nothing;
    std::vector<TitleArgument> arguments{};
    /// What is said behind it, each after a comma: of a step that changes voxels or the surface the
    /// last is what it changed; else what was done besides.
    std::vector<RowTitle> then{};
    bool operator==(const RowTitle& other) const; // not by default: titles stand in titles
};

[[nodiscard]] inline TitleDecimal inMm(double mm)
{
    return {.value = mm, .decimals = 1};
}

/// A title inside of another one.
[[nodiscard]] inline TitleArgument asArgument(RowTitle title)
{
    return std::vector<RowTitle>{std::move(title)};
}

/// The name that is stored of a row, and part of the hash chain: what a title gives never changes.
[[nodiscard]] QString canonicalName(const RowTitle& title);

/// Without what it says last, as rows quote it: "Drill 6.2 mm" of "Drill 6.2 mm, 214 bricks".
[[nodiscard]] RowTitle headlineOf(RowTitle title);

/// How deep titles stand in each other; 1: none does.
[[nodiscard]] int depthOf(const RowTitle& title);

} // namespace core
