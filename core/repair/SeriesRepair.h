// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <array>
#include <cstdint>
#include <optional>

namespace core {

/// What is done to a series on loading it; its files stay as they are. Part of how a volume is
/// named: the same words on the same files give the same voxels on every machine.
///
/// | words | what |
/// |---|---|
/// | `tilt` | the tilt is sheared out: slices are shifted in their planes until they lie straight |
/// | `spacing=even` | slices at even distances, interpolated between those that there are |
/// | `gap=fill` | missing slices are interpolated, those that are there stay |
/// | `gap=split:2` | the second of the parts that gaps, or changes of the distance, divide it into
/// | | `duplicates=first`, `duplicates=last` | of several images at one place the one with the
/// least, or the greatest, instance number |
/// | `spacing=0.5x0.5x2` | of pictures, which need not say it: voxels are so many millimetres apart
/// along columns, rows and slices |
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
    /// What it is but for the spacing.
    [[nodiscard]] SeriesRepair withoutSpacing() const;
    /// Whether voxels no longer lie where those of the slices lie.
    [[nodiscard]] bool movesVoxels() const { return tilt || lattice != Lattice::AsIs; }

    /// The words, always in the same order, with commas between them; empty for none.
    [[nodiscard]] QString toText() const;
    /// The same as a clause for people: "tilt sheared out, missing slices filled in".
    [[nodiscard]] QString inWords() const;
    /// @param why gets what is wrong with the words
    [[nodiscard]] static std::optional<SeriesRepair> fromText(
        const QString& text, QString* why = nullptr);
};

/// The word for a spacing that is given: "spacing=0.5x0.5x2". @param sizes three numbers, apart by
/// commas or x, as `--spacing` takes them @param why gets what is wrong with them
[[nodiscard]] std::optional<QString> spacingWord(const QString& sizes, QString* why = nullptr);

/// For the header of an object that was drawn on a repaired series, in ASCII; empty without repair.
/// @param repair Volume::repair
[[nodiscard]] QString repairStamp(const QString& repair);

/// The name of a series together with its repair, as loadVolume() takes it: "UID+tilt,gap=fill".
[[nodiscard]] QString withRepair(const QString& series, const QString& repair);

} // namespace core
