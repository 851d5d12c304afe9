// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/StrokeCases.h"

#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/cases/strokes/RandomStrokes.h"
#include "tests/support/cases/strokes/StrokeFamilies.h"

#include <utility>

namespace test {

std::vector<StrokeCase> strokeCases(int randomCount)
{
    const StrokeScene scene = strokeScene();
    std::vector<StrokeCase> cases;
    addGrowthStrokes(cases, scene);
    addDrillStrokes(cases, scene);
    addPaintStrokes(cases, scene);
    addCarvingStrokes(cases, scene);
    addDocumentStrokes(cases, scene);
    addFillingStrokes(cases, scene);
    addChunkStrokes(cases, scene.volume,
        {scene.first, scene.seeds, scene.some, scene.second, scene.others, scene.some});
    addPieceStrokes(cases, scene);
    for (StrokeCase& surface : surfaceCases())
        cases.push_back(std::move(surface));
    addRandomStrokes(cases, randomCount);
    return cases;
}

} // namespace test
