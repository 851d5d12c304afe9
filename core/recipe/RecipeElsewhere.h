// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/edits/fields/EditFields.h"
#include "core/recipe/Recipe.h"

#include <QString>

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace core {

/// Adapts a recipe that was recorded on one study to another one. Steps bound to places are left
/// out (isBoundToStudy()). An object that a step made has, on this study, the number that the same
/// step gave it here. Steps that need an object that was not made here are also left out, so that
/// no step acts on another segment, layer, piece, bookmark or measurement than it did. The same
/// holds for steps that need a segment that was made of islands if the recipe does not list these
/// segments, and for segments that were made after them.
///
/// Steps are processed in their order: here() for each of them, and carriedOut() for each that was
/// carried out.
class RecipeElsewhere {
public:
    explicit RecipeElsewhere(Recipe recipe);

    /// A step that is not carried out on this study.
    struct LeftOut {
        int entry = 0; ///< its number in the recipe, from 1
        bool bound = false; ///< it is bound to places in the other study
        Clause why; ///< "the piece that edit 3 (cutPiece) makes is not here"; empty if bound
    };
    [[nodiscard]] tl::expected<Edit, LeftOut> here(std::size_t step, const Document& now) const;
    /// Records what the step made, if it made anything.
    void carriedOut(std::size_t step, const Document& before, const Document& after);

    /// The recipe as recorded.
    [[nodiscard]] const Recipe& recorded() const { return m_recipe; }
    /// Its exports, with the numbers that layers have on this study. To be called after the last
    /// step.
    [[nodiscard]] std::vector<RecipeExport> exports() const;

    /// The adapted recipe, and what will be left out, if every step makes what it can make.
    struct Foreseen {
        Recipe recipe;
        std::vector<LeftOut> leftOut;
    };
    [[nodiscard]] Foreseen foreseen(Document document) const;

private:
    using Kind = editFields::ThingNumber::Thing;
    /// by its number in the study where the recipe was recorded
    using Thing = std::pair<Kind, int>;
    /// By which step each object was made.
    using Makers = std::map<Thing, std::size_t>;

    static const char* wordFor(Kind kind);
    static int lastGiven(Kind kind, const Document& document);
    static bool isThere(Kind kind, int number, const Document& document);
    static std::optional<Kind> mayMake(const Edit& edit);
    [[nodiscard]] Clause titleOf(std::size_t step) const;
    void followRecorded();

    Recipe m_recipe;
    /// before each step, and after the last, in the study where it was recorded
    std::vector<Makers> m_makers;
    std::map<std::size_t, int> m_numbers; ///< number of what each step made on this study
};

} // namespace core
