// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/FuzzTargets.h"

#include "core/recipe/Recipe.h"

namespace test {

using namespace core;

void fuzzRecipe(FuzzBytes bytes)
{
    const ScratchFile file("file.json", bytes);
    Result<Recipe> recipe = readRecipe(file.path());
    if (!recipe)
        return;
    Document document;
    document.volumes.push_back(smallVolume());
    fillSurfaces(*recipe, document.volumes.front());
    (void)checkRecipe(*recipe, document, false);
}

} // namespace test
