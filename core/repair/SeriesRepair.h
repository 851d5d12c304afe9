// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QString>

#include <array>
#include <cstdint>
#include <optional>

namespace core {

/// How a series is changed when it is loaded; its files stay as they are. A repair is part of the
/// name of a volume: the same words on the same files give the same voxels on every machine. The
/// words are:
///
/// - `tilt`: removes the shear of a gantry tilt by shifting slices in their planes until they are
///   aligned
/// - `spacing=even`: slices at even distances, interpolated between the original ones
/// - `gap=fill`: missing slices are interpolated, the original ones stay
/// - `gap=split:2`: the second of the parts into which gaps, or changes of the distance, divide it
/// - `duplicates=first`, `duplicates=last`: of several images at one position the one with the
///   lowest or the greatest instance number
/// - `spacing=0.5x0.5x2`: for pictures, which need not state it: the distance of voxels in
///   millimetres along columns, rows and slices
struct SeriesRepair {
    enum class Duplicates : std::uint8_t { Keep, First, Last };
    enum class Lattice : std::uint8_t { AsIs, Even, Filled };

    Duplicates duplicates = Duplicates::Keep;
    int part = 0; ///< 1-based; 0: the whole
    Lattice lattice = Lattice::AsIs;
    bool tilt = false;
    std::optional<std::array<double, 3>> givenSpacingMm{};

    bool operator==(const SeriesRepair&) const = default;
    [[nodiscard]] bool isNone() const { return *this == SeriesRepair(); }
    /// The repair without its spacing.
    [[nodiscard]] SeriesRepair withoutSpacing() const;
    /// Whether voxels are no longer at the positions of the slices' voxels.
    [[nodiscard]] bool movesVoxels() const { return tilt || lattice != Lattice::AsIs; }

    /// The words, always in the same order, separated by commas; empty for none.
    [[nodiscard]] QString toText() const;
    /// The same as a clause for the user: "tilt sheared out, missing slices filled in".
    [[nodiscard]] Clause inWords() const;
    /// @param why receives what is wrong with the words
    [[nodiscard]] static std::optional<SeriesRepair> fromText(
        const QString& text, Clause* why = nullptr);
};

/// The word for a given spacing: "spacing=0.5x0.5x2".
/// @param sizes three numbers separated by commas or x, as in `--spacing`
/// @param why receives what is wrong with them
[[nodiscard]] std::optional<QString> spacingWord(const QString& sizes, Clause* why = nullptr);

/// A note for the header of an object that was drawn on a repaired series, in ASCII; empty without
/// repair.
/// @param repair Volume::repair
[[nodiscard]] QString repairStamp(const QString& repair);

/// The name of a series with its repair, in the form of loadVolume(): "UID+tilt,gap=fill".
[[nodiscard]] QString withRepair(const QString& series, const QString& repair);

} // namespace core
