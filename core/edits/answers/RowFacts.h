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

/// Access to earlier rows of the history, for titles that mention them. The history itself belongs
/// to a higher layer.
class Past {
public:
    virtual ~Past() = default;

    /// The title of a row without the figures at its end: "Drill 6.2 mm, 214 bricks" → "Drill 6.2
    /// mm".
    [[nodiscard]] virtual RowTitle headlineOf(std::int64_t row) const = 0;
    /// @pre the row's edit is a cut
    [[nodiscard]] virtual StrokeParameters cutOf(std::int64_t row) const = 0;
};

/// What became of sketched seeds (core/session/past/SketchedSeeds.h).
struct SketchedTitle {
    RowTitle became; ///< "3 of 5 voxels (2 belong to 'Skull')"
    /// it states only a number: all became seeds, and no other segment is involved
    bool isPlain = true;
};

/// What a row's title is made from, beside its edit.
struct RowFacts {
    const EditStatistics& statistics;
    const ChangeFacts& facts; ///< of what it changed
    const Document& document; ///< as it is before the edit
    const Past& past; ///< before the row
    std::optional<SketchedTitle> sketched{}; ///< of a SeedStroke; none: not determined

    /// What a segment gained and lost; if there is no such segment, the changes of its label in the
    /// first plane.
    [[nodiscard]] LabelFlow flowOf(int label) const
    {
        const Segment* segment = document.segment(label);
        return facts.flow(segment ? segment->plane : std::uint8_t(0), label);
    }
};

} // namespace core
