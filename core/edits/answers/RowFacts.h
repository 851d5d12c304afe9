// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/EditStatistics.h"
#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/answers/RowWords.h"
#include "core/edits/kinds/parts/StrokeParameters.h"
#include "core/engine/ChangeFacts.h"
#include "core/titles/RowTitle.h"

#include <cstdint>
#include <optional>

namespace core {

/// Rows of the history, for titles that speak of them; the history itself lies above edits.
class Past {
public:
    virtual ~Past() = default;

    /// Without the figures at its end: "Drill 6.2 mm, 214 bricks" → "Drill 6.2 mm".
    [[nodiscard]] virtual RowTitle headlineOf(std::int64_t row) const = 0;
    /// @pre the row's edit is a cut
    [[nodiscard]] virtual StrokeParameters cutOf(std::int64_t row) const = 0;
};

/// What became of sketched seeds (core/session/past/SketchedSeeds.h).
struct SketchedTitle {
    RowTitle became; ///< "3 of 5 voxels (2 belong to 'Skull')"
    bool isPlain = true; ///< no more than how many: all became seeds, of nobody else
};

/// What a row's title is made from, beside its edit.
struct RowFacts {
    const EditStatistics& statistics;
    const ChangeFacts& facts; ///< of what it changed
    const Document& document; ///< as it is before the edit
    const Past& past; ///< before the row
    std::optional<SketchedTitle> sketched{}; ///< of a SeedStroke; none: nobody asked

    /// What a segment gained and lost; if there is no such segment, the changes of its label in the
    /// first plane.
    [[nodiscard]] LabelFlow flowOf(int label) const
    {
        const Segment* segment = document.segment(label);
        return facts.flow(segment ? segment->plane : std::uint8_t(0), label);
    }
};

} // namespace core
