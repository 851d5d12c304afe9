// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "tests/support/cases/strokes/StrokeFamilies.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"

namespace test {

void addDrillStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene)
{
    const core::LoadedVolume& volume = scene.volume;
    const core::Edit& first = scene.first;
    const core::Edit& seeds = scene.seeds;
    const core::Edit& some = scene.some;
    const core::Edit& all = scene.all;
    const core::Edit& drill = scene.drill;
    const core::Edit& beside = scene.beside;
    const StrokeFacts said = factsOfStroke(drill);

    cases.push_back({"drill", volume, {}, drill});
    cases.push_back({"drill in a drill", volume, {drill}, drill});
    cases.push_back({"drill on a segment", volume, {first, seeds, all}, drill});
    cases.push_back({"undo only a drill", volume, {first, drill, seeds, all}, revertRows({2})});
    cases.push_back(
        {"undo only two growths", volume, {first, seeds, some, all, drill}, revertRows({3, 4})});
    cases.push_back({"undo only what was undone only", volume,
        {first, drill, seeds, revertRows({2})}, revertRows({4})});

    cases.push_back({"revise a drill", volume, {first, drill, seeds, beside, all},
        core::ReviseStroke{.row = 2, .radiusMm = said.mask.radiusMm * 1.5}});
    cases.push_back({"remove a drill", volume, {drill, beside, drill},
        core::ReviseStroke{.row = 1, .removed = true}});
    cases.push_back({"revise a revised drill", volume,
        {drill, beside, core::ReviseStroke{.row = 1, .removed = true}},
        core::ReviseStroke{.row = 1, .depthMm = 0.5 * said.depthMm}});
}

void addCarvingStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene)
{
    const core::LoadedVolume& volume = scene.volume;
    const core::Edit& first = scene.first;
    const core::Edit& seeds = scene.seeds;
    const core::Edit& all = scene.all;
    const core::Edit& drill = scene.drill;
    const core::Edit& drillBack = scene.drillBack;
    const core::Edit& brush = scene.brush;
    const core::Edit& back = scene.back;
    const core::Edit& peel = scene.peel;
    const core::Edit& peelBack = scene.peelBack;
    const StrokeFacts said = factsOfStroke(drill);

    cases.push_back({"carve brush", volume, {drill}, brush});
    cases.push_back({"restore", volume, {drill, brush}, back});
    auto pressed = brush.get<core::BrushStroke>();
    pressed.path.pressures = std::vector<double>{0.3, 0.9, 0.5};
    cases.push_back({"carve as the pen is pressed", volume, {drill}, pressed});
    cases.push_back({"revise a brush that was pressed", volume, {drill, pressed, drill},
        core::ReviseStroke{.row = 2, .radiusMm = 7.0}});
    auto cube = pressed;
    cube.path.shape = core::BrushPath::Shape::Cube;
    cube.path.normalLps = glm::dvec3(0.2, 0.1, 1.0);
    cube.path.sideLps = glm::dvec3(1.0, 0.0, 0.0);
    cases.push_back({"carve a cube", volume, {drill}, cube});
    cases.push_back({"revise a cube", volume, {drill, cube, drill},
        core::ReviseStroke{.row = 2, .radiusMm = 7.0}});
    cases.push_back({"restore what is whole", volume, {}, back});
    cases.push_back({"drill after the brush", volume, {brush, back}, drill});
    cases.push_back({"revise a drill below the brush", volume, {drill, brush, back, drill},
        core::ReviseStroke{.row = 1, .radiusMm = said.mask.radiusMm * 1.5}});
    cases.push_back({"remove a drill below the brush", volume, {drill, brush, back},
        core::ReviseStroke{.row = 1, .removed = true}});
    cases.push_back({"undo only the brush", volume, {first, brush, seeds, all}, revertRows({2})});

    core::ScissorsCut scissors;
    scissors.view = said.view;
    scissors.polygonMm = {{-6.0, -20.0}, {6.0, -20.0}, {6.0, 20.0}, {-6.0, 20.0}};
    scissors.surfaceThreshold = said.surfaceThreshold;
    core::ScissorsCut shallow = scissors;
    shallow.depthMm = 5.0;
    core::ScissorsCut layerOnly = scissors;
    layerOnly.firstLayerOnly = true;
    cases.push_back({"peel", volume, {}, peel});
    cases.push_back({"restore by peeling", volume, {drill, peel}, peelBack});
    cases.push_back({"scissors", volume, {drill}, scissors});
    cases.push_back({"scissors to a depth", volume, {}, shallow});
    cases.push_back({"scissors through a layer", volume, {peel}, layerOnly});
    cases.push_back({"restore by drilling", volume, {peel, drill}, drillBack});
    cases.push_back({"undo only a peel", volume, {first, peel, seeds, all}, revertRows({2})});
    cases.push_back({"revise a drill below a peel", volume, {drill, peel, drillBack, shallow},
        core::ReviseStroke{.row = 1, .radiusMm = said.mask.radiusMm * 1.5}});
    cases.push_back({"remove a drill below a peel", volume, {drill, peel, peelBack, drill},
        core::ReviseStroke{.row = 1, .removed = true}});

    core::ToolMask soft = said.mask;
    soft.softnessMm = 0.6 * soft.radiusMm;
    cases.push_back({"drill with a soft edge", volume, {}, drillWith({.mask = soft}, drill)});
    cases.push_back({"soften a drill below others", volume, {drill, peel, brush, drill},
        core::ReviseStroke{.row = 1, .softnessMm = soft.softnessMm}});
    cases.push_back({"revise a brush", volume, {drill, brush, peel, drill},
        core::ReviseStroke{.row = 2, .radiusMm = 8.0}});
    cases.push_back({"remove a restoring brush", volume, {drill, brush, back, shallow},
        core::ReviseStroke{.row = 3, .removed = true}});
    cases.push_back({"revise a peel", volume, {peel, drill, peelBack},
        core::ReviseStroke{.row = 1, .depthMm = 7.0, .throughGaps = true}});
    cases.push_back({"revise a restoring peel", volume, {drill, peel, peelBack, drill},
        core::ReviseStroke{.row = 3, .depthMm = 1.0}});
    cases.push_back({"revise scissors", volume, {shallow, peel, brush},
        core::ReviseStroke{.row = 1, .depthMm = 9.0}});
    cases.push_back({"remove scissors", volume, {drill, scissors, back},
        core::ReviseStroke{.row = 2, .removed = true}});
    cases.push_back({"undo only the revision of a brush", volume,
        {first, brush, core::ReviseStroke{.row = 2, .radiusMm = 8.0}, seeds}, revertRows({3})});
    core::LaserStroke laser;
    laser.view = said.view;
    laser.mask = said.mask;
    laser.surfaceThreshold = said.surfaceThreshold;
    laser.samples = said.samples;
    laser.depthMm = 4.0;
    core::LaserStroke laserBack = laser;
    laserBack.restore = true;
    laserBack.depthMm = 2.0;
    core::LaserStroke laserClipped = laser;
    laserClipped.hidden = {{{said.view.targetLps - said.view.eyeLps, 0.0}}};
    core::ClipHalfSpace& side = laserClipped.hidden->front();
    side.normalLps = -glm::normalize(side.normalLps); // what lies before the target
    side.offsetMm = glm::dot(side.normalLps, said.view.targetLps);
    const core::Edit drillClipped = drillWith({.hidden = laserClipped.hidden}, drill);
    auto peelClipped = peel.get<core::PeelCut>();
    peelClipped.hidden = laserClipped.hidden;
    core::ScissorsCut scissorsClipped = scissors;
    scissorsClipped.hidden = laserClipped.hidden;
    auto brushClipped = brush.get<core::BrushStroke>();
    brushClipped.hidden = laserClipped.hidden;
    cases.push_back({"laser", volume, {}, laser});
    cases.push_back({"laser in a drill", volume, {drill}, laser});
    cases.push_back({"restore by laser", volume, {laser, drill}, laserBack});
    cases.push_back({"laser of what is not hidden", volume, {laser}, laserClipped});
    cases.push_back({"drill of what is not hidden", volume, {}, drillClipped});
    cases.push_back({"peel of what is not hidden", volume, {}, peelClipped});
    cases.push_back({"scissors of what is not hidden", volume, {}, scissorsClipped});
    cases.push_back({"brush of what is not hidden", volume, {}, brushClipped});
    cases.push_back({"undo only a laser", volume, {first, laser, seeds, all}, revertRows({2})});
    cases.push_back({"revise a drill below a laser", volume, {drill, laser, laserBack, shallow},
        core::ReviseStroke{.row = 1, .radiusMm = said.mask.radiusMm * 1.5}});
    cases.push_back({"revise a laser", volume, {laser, drill, laserBack},
        core::ReviseStroke{.row = 1, .depthMm = 7.0, .softnessMm = 1.5}});
    cases.push_back({"remove a drill below a laser", volume, {drill, laser, drill},
        core::ReviseStroke{.row = 1, .removed = true}});
}

} // namespace test
