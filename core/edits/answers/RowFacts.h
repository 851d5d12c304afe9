// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/EditStatistics.h"
#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/answers/RowWords.h"
#include "core/edits/kinds/parts/StrokeParameters.h"
#include "core/engine/ChangeFacts.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace core {

/// Rows of the history, for names that speak of them; the history itself lies above edits.
class Past {
public:
    virtual ~Past() = default;

    /// A row's name without the figures at its end: "Drill 6.2 mm, 214 bricks" → "Drill 6.2 mm".
    [[nodiscard]] virtual QString titleOf(std::int64_t row) const = 0;
    /// @pre the row's edit is a cut
    [[nodiscard]] virtual StrokeParameters cutOf(std::int64_t row) const = 0;
};

/// What became of sketched seeds (core/session/past/SketchedSeeds.h).
struct SketchedWords {
    QString text; ///< "3 of 5 voxels (2 belong to 'Skull')"
    QString whyNotTaken; ///< what stands in the brackets; empty: all became seeds, of nobody else
};

/// What a row's name is made from, beside its edit.
struct RowFacts {
    const EditStatistics& statistics;
    const ChangeFacts& facts; ///< of what it changed
    const Document& document; ///< as it is before the edit
    const Past& past; ///< before the row
    std::optional<SketchedWords> sketched{}; ///< of a SeedStroke; none: nobody asked
};

} // namespace core
