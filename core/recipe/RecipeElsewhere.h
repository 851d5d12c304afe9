// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/fields/EditFields.h"
#include "core/recipe/Recipe.h"

#include <QString>

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace core {

/// A recipe that was recorded on one study, carried out on another. What is bound to places is left
/// out (isBoundToStudy()). Whatever a step made has here the number that the same step gave it
/// here, and steps that need what was not made here are left out too, so that none acts on another
/// segment, layer, piece, bookmark or measurement than it did.
///
/// Its steps are gone through in their order: here() for each, and carriedOut() where there was
/// something to carry out.
class RecipeElsewhere {
public:
    explicit RecipeElsewhere(Recipe recipe);

    /// A step that is not carried out here.
    struct LeftOut {
        int entry = 0; ///< its place in the recipe, from 1
        bool bound = false; ///< to places in the other study
        QString why; ///< "the piece that edit 3 (cutPiece) makes is not here"; empty where bound
    };
    [[nodiscard]] tl::expected<Edit, LeftOut> here(std::size_t step, const Document& now) const;
    /// Takes in what the step made, if anything came of it.
    void carriedOut(std::size_t step, const Document& before, const Document& after);

    /// The recipe as recorded.
    [[nodiscard]] const Recipe& recorded() const { return m_recipe; }
    /// Its exports, with the numbers that layers have here. After the last step.
    [[nodiscard]] std::vector<RecipeExport> exports() const;

    /// As it will read here, and what will be left out, if every step that can make something does.
    struct Foreseen {
        Recipe recipe;
        std::vector<LeftOut> leftOut;
    };
    [[nodiscard]] Foreseen foreseen(Document document) const;

private:
    using Kind = editFields::ThingNumber::Thing;
    using Thing = std::pair<Kind, int>; ///< by its number where the recipe was recorded
    /// By which step each thing was made.
    using Makers = std::map<Thing, std::size_t>;

    static const char* wordFor(Kind kind);
    static int lastGiven(Kind kind, const Document& document);
    static bool isThere(Kind kind, int number, const Document& document);
    static std::optional<Kind> mayMake(const Edit& edit);
    [[nodiscard]] QString titleOf(std::size_t step) const;
    void followRecorded();

    Recipe m_recipe;
    std::vector<Makers> m_makers; ///< before each step, where it was recorded; and after the last
    std::map<std::size_t, int> m_numbers; ///< what each maker made here
};

} // namespace core
