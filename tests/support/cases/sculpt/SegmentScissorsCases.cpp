// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/sculpt/labels/LabelScissors.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"

namespace test {

namespace {

using core::LabelScissors;
using core::SegmentScissors;

/// Voxels with sides of 1 mm, the first one in the middle of the patient, and some segments.
core::Document plainScene(const glm::ivec3& size, int segments)
{
    core::Volume volume;
    volume.geometry.size = size;
    core::Document document;
    document.volumes.push_back(volume);
    for (int label = 1; label <= segments; ++label) {
        core::Segment segment;
        segment.label = std::uint8_t(label);
        document.segments.push_back(segment);
    }
    return document;
}

/// Looks along an axis of such a scene from its low end; a is right of the middle, b above it.
SegmentScissors along(int axis, const glm::ivec3& size, const std::vector<glm::dvec2>& polygonMm)
{
    glm::dvec3 forward(0.0);
    forward[axis] = 1.0;
    const glm::dvec3 middle = (glm::dvec3(size) - 1.0) / 2.0;
    SegmentScissors scissors{.segment = 1, .polygonMm = polygonMm};
    scissors.view.eyeLps = middle - 100.0 * forward;
    scissors.view.targetLps = middle;
    scissors.view.up = axis == 2 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    return scissors;
}

EngineCase randomScissoring(int number)
{
    Random random(std::uint32_t(97000 + number));
    const int x = randomInt(random, 1, 44);
    const int y = randomInt(random, 1, 40);
    const int z = randomInt(random, 1, 36);
    const glm::ivec3 size(x, y, z);
    core::Document scene = randomDocument(size, random, random() % 2 == 0);
    scene.segments = plainScene(size, 5).segments;
    const auto plane = std::uint8_t(random() % 6 ? 0 : 1);
    for (core::Segment& segment : scene.segments)
        segment.plane = plane;
    EngineCase made{"random scissors of segments " + QByteArray::number(number),
        random() % 2 ? noiseVolume(size, tissueCode, random) : balls(size, 4, random), {}};
    if (random() % 4)
        made.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 8, random), core::Field::Labels, plane)}));
    for (int edit = randomInt(random, 4, 12); edit > 0; --edit) {
        const int what = int(random() % 8);
        if (!appendBetween(made.steps, what, plane, size, random))
            appendWhole(made.steps,
                *core::labelScissors(randomSegmentScissors(scene, random), scene), {},
                random() % 5 ? core::Ending::Commit : core::Ending::Rollback);
    }
    return made;
}

} // namespace

std::vector<EngineCase> segmentScissorsCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const glm::ivec3 size(35, 33, 18); // no multiple of a brick along any axis
    Random random(29);
    const core::Document scene = plainScene(size, 4);
    const std::vector<glm::dvec2> square{{-6.0, -5.0}, {7.0, -5.0}, {7.0, 6.0}, {-6.0, 6.0}};
    const auto engineForm = [&scene](const SegmentScissors& edit) {
        return core::labelScissors(edit, scene).value();
    };

    EngineCase axes{"scissors along each axis", noiseVolume(size, tissueCode, random), {}};
    for (int axis = 0; axis < 3; ++axis) {
        SegmentScissors cut = along(axis, size, square);
        cut.segment = axis + 1;
        appendWhole(axes.steps, engineForm(cut));
        cut.overwriteUnlocked = true;
        cut.depthMm = 4.0;
        appendWhole(axes.steps, engineForm(cut)); // from the border on
        cut.lower = tissueCode / 2;
        appendWhole(axes.steps, engineForm(cut)); // from the first one of some value on
        cut = along(axis, size, square);
        cut.erase = true;
        cut.depthMm = 2.5;
        cut.others = std::vector<int>{2, 3};
        appendWhole(axes.steps, engineForm(cut));
    }
    SegmentScissors keep = along(1, size, square);
    keep.erase = true;
    keep.outside = true;
    appendWhole(axes.steps, engineForm(keep), {}, core::Ending::Rollback);
    appendWhole(axes.steps, engineForm(keep));
    keep.erase = false;
    keep.segment = 4;
    appendWhole(axes.steps, engineForm(keep)); // all the rest
    for (int i = 0; i < 6; ++i)
        axes.steps.push_back(Undo{});
    axes.steps.push_back(Redo{});
    cases.push_back(axes);

    // Two sheets behind each other, and a lone voxel between them in another brick.
    EngineCase sheets{"scissors that reach a depth", constantVolume(size, 500), {}};
    reference::DenseArray<std::uint8_t> labels{
        size, std::vector<std::uint8_t>(std::size_t(size.x * size.y * size.z), 0)};
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            labels.at({x, y, 2}) = 1;
            labels.at({x, y, 17}) = std::uint8_t(1 + x % 2);
        }
    }
    labels.at({17, 16, 9}) = 1;
    sheets.steps.push_back(command(core::SwapBricks{bricksOf(labels, core::Field::Labels, 0)}));
    SegmentScissors shallow = along(2, size, square);
    shallow.erase = true;
    shallow.depthMm = 1.0;
    for (int press = 0; press < 4; ++press)
        appendWhole(
            sheets.steps, engineForm(shallow)); // a sheet, the voxel, half of the other sheet
    shallow.view.eyeLps.z = 100.0; // from behind
    shallow.others = std::vector<int>{2};
    appendWhole(sheets.steps, engineForm(shallow));
    shallow.hidden = std::vector<core::ClipHalfSpace>{beyond({0.0, 0.0, 10.0}, {0.0, 0.0, 1.0})};
    shallow.polygonMm = {{-40.0, -40.0}, {40.0, -40.0}, {40.0, 40.0}, {-40.0, 40.0}};
    appendWhole(sheets.steps, engineForm(shallow)); // the sheet behind the plane stays
    cases.push_back(sheets);

    EngineCase grown{"scissors among members and seeds", noiseVolume(size, 99, random), {}};
    appendWhole(grown.steps, core::SeedPlacement{.label = 1, .voxels = {{0, 0, 0}, size / 2}});
    appendWhole(grown.steps, core::SeedPlacement{.label = 2, .voxels = {{1, 0, 0}, size - 1}});
    appendBurst(grown.steps, {.lowCode = 0, .highCode = 65535}, 6);
    appendWhole(grown.steps, core::SeedPlacement{.label = 3, .voxels = {{17, 16, 0}}});
    SegmentScissors members = along(2, size, square);
    members.erase = true;
    members.others = std::vector<int>{3}; // a seed that waits goes, too
    appendWhole(grown.steps, engineForm(members));
    appendBurst(grown.steps, {.lowCode = 0, .highCode = 65535}, 3);
    members = along(0, size, square);
    members.overwriteUnlocked = true;
    appendWhole(grown.steps, engineForm(members));
    appendBurst(grown.steps, {.lowCode = 0, .highCode = 65535}, 3);
    for (int i = 0; i < 4; ++i)
        grown.steps.push_back(Undo{});
    cases.push_back(grown);

    EngineCase refused{"scissors that are not sound", constantVolume(size, 500), {}};
    const LabelScissors sound = engineForm(along(0, size, square));
    LabelScissors wrong = sound;
    wrong.target.label = 0;
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.erased.set(0);
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.outside = wrong.fromSurface = true;
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.mask.values.pop_back();
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.mask.first.x = 1 << 29;
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.frame.pitch = 0;
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.mask = {};
    appendWhole(refused.steps, wrong); // nothing is under it
    wrong.fromSurface = true;
    appendWhole(refused.steps, wrong);
    appendWhole(refused.steps, sound);
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomScissoring(number));
    return cases;
}

} // namespace test
