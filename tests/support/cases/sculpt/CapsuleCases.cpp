// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/scenes/CutEdits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace test {

namespace {

using core::BrushPath;
using core::BrushStroke;
using core::Capsule;
using core::CapsuleCut;
using core::CapsulePath;
using core::PaintLabel;
using core::PaintStroke;

glm::dvec3 randomPoint(const core::VolumeGeometry& geometry, Random& random, double beyond)
{
    glm::dvec3 at;
    for (int axis = 0; axis < 3; ++axis)
        at[axis] = (randomUnit(random) * (1.0 + 2.0 * beyond) - beyond) * geometry.size[axis];
    return geometry.toWorld(at);
}

/// Makes a square of a disc and a cube of a ball; a side runs along the row, column or stack of
/// voxels that is most nearly across the normal.
void makeSquare(BrushPath& path, const core::VolumeGeometry& geometry)
{
    const glm::dmat3 direction = geometry.direction();
    path.shape = core::isFlat(path.shape) ? BrushPath::Shape::Square : BrushPath::Shape::Cube;
    if (!path.normalLps)
        path.normalLps = direction[1] + 0.4 * direction[2];
    const auto slant = [&](int axis) {
        return std::abs(glm::dot(glm::normalize(*path.normalLps), direction[axis]));
    };
    int across = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (slant(axis) < slant(across))
            across = axis;
    }
    path.sideLps = direction[across];
}

template <class T> T valueOf(core::Result<T> result)
{
    if (!result)
        throw std::invalid_argument(
            result.error().arguments.join(QStringLiteral(": ")).toStdString());
    return *std::move(result);
}

CapsulePath capsulesOf(const BrushPath& path, const core::Document& document)
{
    return CapsulePath{core::capsules(path, document.volumes.front().geometry)};
}
CapsulePath pathOf(const PaintStroke& stroke, const core::Document& document)
{
    return core::paintPath(stroke, document.volumes.front().geometry);
}

template <class T> void shuffle(std::vector<T>& list, Random& random)
{
    for (std::size_t i = list.size(); i > 1; --i)
        std::swap(list[i - 1], list[random() % i]);
}

/// In pieces of a few capsules, in any order, some of them twice; what is there so far is read in
/// between. Voxels under the pen come a third of them at a time, whatever the capsules, and the
/// rest at last.
void append(std::vector<EngineStep>& steps, const core::EngineEdit& edit, const core::BrickKey& key,
    const CapsulePath& whole, Random& random, core::Ending ending = core::Ending::Commit)
{
    std::vector<Capsule> path = whole.capsules;
    std::vector<glm::ivec3> under(whole.under.rbegin(), whole.under.rend());
    const std::size_t underAtOnce = under.size() / 3 + 1;
    steps.push_back(command(core::BeginEdit{edit}));
    if (random() % 2)
        shuffle(path, random);
    for (std::size_t i = random() % 3 ? 0 : path.size(); i > 0 && i < 40; i -= 2)
        path.push_back(path[random() % path.size()]);
    for (std::size_t first = 0; first < path.size();) {
        const auto count =
            std::min<std::size_t>(path.size() - first, std::size_t(randomInt(random, 1, 9)));
        CapsulePath further{
            {path.begin() + std::ptrdiff_t(first), path.begin() + std::ptrdiff_t(first + count)}};
        const auto told = std::ptrdiff_t(std::min(underAtOnce, under.size()));
        further.under.assign(under.begin(), under.begin() + told);
        under.erase(under.begin(), under.begin() + told);
        steps.push_back(command(core::ExtendEdit{std::move(further)}));
        if (random() % 3 == 0)
            steps.push_back(command(core::ReadBricks{{key}}));
        first += count;
    }
    if (!under.empty())
        steps.push_back(command(core::ExtendEdit{CapsulePath{{}, std::move(under)}}));
    steps.push_back(command(core::EndEdit{ending}));
}

/// A case under construction.
struct Scene {
    Random random;
    core::Document document;
    EngineCase made;

    Scene(QByteArray name, std::uint32_t seed, const glm::ivec3& size, bool sheared = false)
        : random(seed)
        , document(randomDocument(size, random, sheared))
        , made{std::move(name), noiseVolume(size, tissueCode, random), {}}
    {
        for (const std::uint8_t label : {std::uint8_t(1), std::uint8_t(2), std::uint8_t(255)})
            document.segments.push_back({.label = label, .plane = 0});
    }

    void append(const PaintStroke& stroke, core::Ending ending = core::Ending::Commit)
    {
        const PaintLabel paint = valueOf(core::paintLabel(stroke, document));
        test::append(made.steps, paint, {core::Field::Labels, paint.plane, 0},
            pathOf(stroke, document), random, ending);
    }
    void append(const core::BarrierStroke& stroke, core::Ending ending = core::Ending::Commit)
    {
        const core::PaintBarrier barrier = valueOf(core::paintBarrier(stroke, document));
        test::append(made.steps, barrier, {core::Field::SeedWords, barrier.plane, 0},
            capsulesOf(stroke.path, document), random, ending);
    }
    void append(const BrushStroke& stroke, core::Ending ending = core::Ending::Commit)
    {
        const CapsuleCut cut = valueOf(core::capsuleCut(stroke, document));
        test::append(made.steps, cut, {core::Field::Coverage, cut.layer, 0},
            capsulesOf(stroke.path, document), random, ending);
    }
};

/// Integers that a stroke would not have, within what the rules allow.
void disturb(core::CapsuleFrame& frame, Random& random)
{
    switch (random() % 8) {
    case 0:
        frame.rampHalfWidth = randomInt(random, 1, 3 * frame.rampHalfWidth);
        break;
    case 1:
        frame.shift = std::min(frame.shift + randomInt(random, 0, 4), 15);
        break;
    case 2:
        frame.halfThickness = randomInt(random, 0, 3 * frame.halfThickness);
        break;
    case 3:
        frame.radius = randomInt(random, 0, frame.radius);
        break;
    default:
        break;
    }
}

EngineCase randomPainting(int number)
{
    Random random(std::uint32_t(15000 + number));
    const glm::ivec3 size{
        randomInt(random, 1, 40), randomInt(random, 1, 40), randomInt(random, 1, 40)};
    Scene scene("random brush " + QByteArray::number(number), std::uint32_t(16000 + number), size,
        random() % 2);
    std::vector<EngineStep>& steps = scene.made.steps;
    const auto ending = [&] {
        return random() % 5 ? core::Ending::Commit : core::Ending::Rollback;
    };
    for (int edit = randomInt(random, 3, 9); edit > 0; --edit) {
        switch (random() % 9) {
        case 0:
            steps.push_back(Undo{});
            break;
        case 1:
            steps.push_back(Redo{});
            break;
        case 2: {
            core::SeedPlacement seeds{.label = std::uint8_t(random() % 2 ? 1 : 255)};
            appendSeeds(steps, seeds, randomInt(random, 1, 3), size, random);
            break;
        }
        case 3: {
            core::GrowBurst burst{.lowCode = 0, .highCode = randomInt(random, 0, tissueCode)};
            burst.overwritable[2] = random() % 2;
            steps.push_back(BeginGrowth{burst});
            steps.push_back(command(core::ExtendEdit{core::GrowAdvance{randomInt(random, 1, 4)}}));
            steps.push_back(command(core::EndEdit{}));
            break;
        }
        case 4:
        case 5: {
            const BrushStroke stroke = randomBrush(scene.document, random);
            CapsuleCut cut = valueOf(core::capsuleCut(stroke, scene.document));
            disturb(cut.frame, random);
            append(steps, cut, {core::Field::Coverage, cut.layer, 0},
                capsulesOf(stroke.path, scene.document), random, ending());
            break;
        }
        default: {
            PaintStroke stroke = randomPaint(scene.document, random);
            PaintLabel paint = valueOf(core::paintLabel(stroke, scene.document));
            paint.plane = random() % 6 ? 0 : 1;
            disturb(paint.frame, random);
            append(steps, paint, {core::Field::SeedWords, paint.plane, 0},
                pathOf(stroke, scene.document), random, ending());
            break;
        }
        }
    }
    return std::move(scene.made);
}

} // namespace

core::BrushPath randomPath(const core::Document& document, Random& random)
{
    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    const double reach = glm::length(glm::dvec3(geometry.size) * geometry.spacingMm()) / 2.0;
    BrushPath path;
    path.radiusMm = random() % 8 ? 0.3 + 0.4 * reach * randomUnit(random) : 0.02;
    if (random() % 2) {
        path.shape = BrushPath::Shape::Disc;
        const glm::dmat3 direction = geometry.direction();
        const int axis = randomInt(random, 0, 2);
        path.normalLps = random() % 3
            ? glm::normalize(glm::cross(direction[(axis + 1) % 3], direction[(axis + 2) % 3]))
            : glm::dvec3{randomUnit(random), randomUnit(random) - 0.5, randomUnit(random) + 0.01};
    }
    path.pointsLps.push_back(randomPoint(geometry, random, 0.1));
    for (int i = randomInt(random, 0, 6); i > 0; --i) {
        switch (random() % 8) {
        case 0:
            path.pointsLps.push_back(path.pointsLps.back()); // the pen rests
            break;
        case 1:
            path.pointsLps.push_back(randomPoint(geometry, random, 3.0));
            break;
        case 2:
            path.lifts.push_back(std::int64_t(path.pointsLps.size()));
            path.pointsLps.push_back(randomPoint(geometry, random, 0.1));
            break;
        default:
            path.pointsLps.push_back(randomPoint(geometry, random, 0.1));
            break;
        }
    }
    // Short ones by a pen whose pressure changes, a wide one by less, since the oracle goes through
    // the volume for each of the many pieces. It follows from the places, so that paths are what
    // they are without it.
    if (path.pointsLps.size() == 2 || path.pointsLps.size() == 3) {
        const double least = path.radiusMm < 3.0 ? 0.0 : 0.8;
        path.pressures.emplace();
        for (const glm::dvec3& point : path.pointsLps) {
            const double turns = 0.37 * std::abs(point.x) + 0.11 * std::abs(point.y);
            path.pressures->push_back(least + (1.0 - least) * (turns - std::floor(turns)));
        }
    }
    // Some have corners; it follows from the places too.
    const double share = 0.71 * std::abs(path.pointsLps.front().y);
    if (share - std::floor(share) < 0.4)
        makeSquare(path, geometry);
    return path;
}

core::PaintStroke randomPaint(const core::Document& document, Random& random)
{
    PaintStroke stroke;
    stroke.segment = document.segments[random() % document.segments.size()].label;
    stroke.path = randomPath(document, random);
    stroke.erase = random() % 3 == 0;
    stroke.seeds = random() % 2;
    stroke.overwriteUnlocked = random() % 2;
    if (random() % 3 == 0)
        stroke.lower = randomInt(random, 0, tissueCode / 2);
    if (random() % 3 == 0)
        stroke.upper = randomInt(random, tissueCode / 2, tissueCode);
    // Some follow edges, in noise that is about as thick as it takes to hold together; which of
    // them follows from the places, as in randomPath().
    const glm::dvec3& first = stroke.path.pointsLps.front();
    const double share = 0.53 * std::abs(first.x) - std::floor(0.53 * std::abs(first.x));
    const double width = 0.29 * std::abs(first.z) - std::floor(0.29 * std::abs(first.z));
    if (share < 0.4)
        stroke.edgeTolerance = std::floor((0.05 + 0.4 * width) * tissueCode);
    if (share < 0.2 && stroke.path.pressures)
        stroke.toleranceByPressure = true;
    return stroke;
}

core::BrushStroke randomBrush(const core::Document& document, Random& random)
{
    BrushStroke stroke;
    stroke.layer = randomInt(random, 1, 2);
    stroke.path = randomPath(document, random);
    stroke.restore = random() % 3 == 0;
    stroke.hidden = randomHidden(document, random);
    return stroke;
}

std::vector<EngineCase> capsuleCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const auto add = [&](Scene& scene) { cases.push_back(std::move(scene.made)); };
    const glm::ivec3 size(33, 20, 17);

    for (const char* name : {"one voxel", "one slice", "one row"}) {
        const glm::ivec3 small = name[4] == 'v' ? glm::ivec3(1, 1, 1)
            : name[4] == 's'                    ? glm::ivec3(24, 17, 1)
                                                : glm::ivec3(1, 40, 1);
        Scene scene(QByteArray("brushes on ") + name, 21, small);
        for (int i = 0; i < 3; ++i) {
            scene.append(randomPaint(scene.document, scene.random));
            scene.append(randomBrush(scene.document, scene.random));
        }
        add(scene);
    }
    for (const char* name : {"ball", "disc", "square", "cube"}) {
        const bool disc = name[0] == 'd' || name[0] == 's';
        Scene scene(QByteArray(name) + ": a point, no way, far away", 22, size, true);
        const core::VolumeGeometry& geometry = scene.document.volumes.front().geometry;
        PaintStroke paint{.segment = 1};
        paint.path.radiusMm = 4.0;
        if (disc) {
            paint.path.shape = BrushPath::Shape::Disc;
            paint.path.normalLps = glm::cross(geometry.direction()[0], geometry.direction()[1]);
        }
        if (name[0] == 's' || name[0] == 'c')
            makeSquare(paint.path, geometry);
        const glm::dvec3 middle = geometry.toWorld(glm::dvec3(size) / 2.0);
        const glm::dvec3 across = geometry.direction()[0];
        for (const auto& points :
            std::vector<std::vector<glm::dvec3>>{{middle}, {middle, middle, middle},
                {middle - 9.0 * across, middle + 9.0 * across}, {middle, middle + 99000.0 * across},
                {middle + 99000.0 * across}, {middle - 90000.0 * across, middle + 90000.0 * across},
                {middle + 500.0 * glm::dvec3(1.0), middle - 90000.0 * glm::dvec3(1.0)}}) {
            paint.path.pointsLps = points;
            scene.append(paint);
            BrushStroke brush;
            brush.path = paint.path;
            scene.append(brush);
            scene.made.steps.push_back(Undo{});
            scene.made.steps.push_back(Undo{});
        }
        paint.path.radiusMm = 200.0; // everything
        scene.append(paint);
        add(scene);
    }
    {
        Scene scene("paint, erase and grow on", 23, size);
        const core::VolumeGeometry& geometry = scene.document.volumes.front().geometry;
        const core::GrowBurst all{.lowCode = 0, .highCode = tissueCode};
        const auto at = [&](double x) {
            return geometry.toWorld(glm::dvec3(x, size.y / 2.0, size.z / 2.0));
        };
        const auto grow = [&](int steps) {
            scene.made.steps.push_back(BeginGrowth{all});
            scene.made.steps.push_back(command(core::ExtendEdit{core::GrowAdvance{steps}}));
            scene.made.steps.push_back(command(core::EndEdit{}));
        };
        PaintStroke paint{.segment = 1};
        paint.path.radiusMm = 3.0;
        paint.path.pointsLps = {at(4.0), at(9.0)};
        paint.seeds = true;
        scene.append(paint);
        grow(3); // what was painted is no ring of the growth
        PaintStroke erase = paint;
        erase.erase = true;
        scene.append(erase);
        grow(2);
        PaintStroke over{.segment = 2};
        over.path.radiusMm = 3.0;
        over.path.pointsLps = {at(4.0), at(20.0)};
        scene.append(over); // nothing of the other one
        over.overwriteUnlocked = true;
        scene.append(over); // takes it, seeds and all
        grow(core::GrowAdvance::toClosure);
        // Paint leaves a barrier be, with seeds and without.
        core::BarrierStroke barrier{.path = paint.path};
        barrier.path.radiusMm = 2.0;
        scene.append(barrier);
        scene.append(paint);
        paint.seeds = false;
        scene.append(paint);
        grow(2);
        barrier.erase = true;
        scene.append(barrier, core::Ending::Rollback);
        scene.append(barrier);
        grow(core::GrowAdvance::toClosure);
        for (int i = 0; i < 12; ++i)
            scene.made.steps.push_back(Undo{});
        for (int i = 0; i < 12; ++i)
            scene.made.steps.push_back(Redo{});
        add(scene);
    }
    for (const char* name : {"ball", "disc", "square", "cube"}) {
        // Tissue with a wall, one voxel thick and bent, that has a hole; the brush is wider than
        // the way to it, and then goes through the hole.
        Scene scene(QByteArray("edges: ") + name, 26, size, name[0] == 'd');
        scene.made.codes = constantVolume(size, 100);
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                if (y != 10 || z != 8)
                    scene.made.codes.at({14 + y / 7, y, z}) = 400;
        const core::VolumeGeometry& geometry = scene.document.volumes.front().geometry;
        const auto at = [&](double x, double y) { return geometry.toWorld({x, y, 8.0}); };
        PaintStroke paint{.segment = 1, .edgeTolerance = 50.0};
        paint.path.radiusMm = 6.0 * geometry.spacingMm().x;
        if (name[0] == 'd' || name[0] == 's') {
            paint.path.shape = BrushPath::Shape::Disc;
            paint.path.normalLps = glm::cross(geometry.direction()[0], geometry.direction()[1]);
        }
        if (name[0] == 's' || name[0] == 'c')
            makeSquare(paint.path, geometry);
        paint.path.pointsLps = {at(11.0, 4.0)};
        scene.append(paint);
        scene.made.steps.push_back(Undo{});
        paint.path.pointsLps = {at(8.0, 4.0), at(12.0, 16.0)}; // along the wall
        scene.append(paint);
        paint.path.pointsLps = {at(9.0, 10.0), at(24.0, 10.0)}; // through the hole
        scene.append(paint, core::Ending::Rollback);
        paint.overwriteUnlocked = true;
        paint.seeds = true;
        scene.append(paint);
        PaintStroke erase = paint;
        erase.erase = true;
        erase.path.pointsLps = {at(20.0, 3.0), at(4.0, 3.0)}; // across it, where there is none
        scene.append(erase);
        erase.path.pointsLps = {at(15.0, 10.0), at(15.0, 4.0)}; // begins in the hole
        scene.append(erase);
        paint.path.pointsLps = {at(15.0, 7.5), at(-40.0, 7.5)}; // begins in the wall, goes out
        paint.lower = 90.0;
        scene.append(paint);
        if (paint.path.normalLps)
            paint.path.normalLps = *paint.path.normalLps + 0.6 * geometry.direction()[0]
                + 0.3 * geometry.direction()[2];
        paint.path.pointsLps = {at(-3.0, 10.0), at(18.0, 12.0)}; // begins outside, oblique
        scene.append(paint);
        for (int i = 0; i < 3; ++i)
            scene.made.steps.push_back(Undo{});
        scene.made.steps.push_back(Redo{});
        add(scene);
    }
    {
        Scene scene("carve and restore beside a drill", 24, size);
        scene.made.codes = constantVolume(size, tissueCode);
        const core::Edit drill = drillWith({.layer = 1}, randomDrill(scene.document, scene.random));
        const core::DrillCut cut = drillCutOf(drill, scene.document);
        appendWhole(scene.made.steps, cut, {core::DrillPath{drillSamplesOf(drill, cut)}});
        for (int i = 0; i < 6; ++i) {
            BrushStroke brush = randomBrush(scene.document, scene.random);
            brush.path.radiusMm = 5.0;
            brush.layer = 1 + i / 4;
            brush.restore = i % 2;
            scene.append(brush, i == 3 ? core::Ending::Rollback : core::Ending::Commit);
        }
        appendWhole(scene.made.steps, cut, {core::DrillPath{drillSamplesOf(drill, cut)}});
        scene.made.steps.push_back(Undo{});
        scene.made.steps.push_back(Undo{});
        scene.made.steps.push_back(Redo{});
        add(scene);
    }
    {
        Scene scene("brushes that are refused", 25, size);
        const PaintStroke stroke = randomPaint(scene.document, scene.random);
        PaintLabel paint = valueOf(core::paintLabel(stroke, scene.document));
        const CapsulePath path = capsulesOf(stroke.path, scene.document);
        PaintLabel outside = paint;
        outside.edges = core::EdgeRule{.start = size, .tolerance = 5};
        appendWhole(scene.made.steps, outside, {path});
        outside.edges = core::EdgeRule{.tolerance = -1};
        appendWhole(scene.made.steps, outside, {path});
        PaintLabel zero = paint;
        zero.label = 0;
        appendWhole(scene.made.steps, zero, {path});
        CapsuleCut cut{.layer = 1, .frame = paint.frame};
        for (const auto spoil : std::array<void (*)(core::CapsuleFrame&), 5>{
                 [](core::CapsuleFrame& frame) { frame.rampHalfWidth = 0; },
                 [](core::CapsuleFrame& frame) { frame.shift = -1; },
                 [](core::CapsuleFrame& frame) { frame.reach = 1 << 30; },
                 [](core::CapsuleFrame& frame) { frame.radius = -1; },
                 [](core::CapsuleFrame& frame) { frame.radius = frame.reach + 1; }}) {
            CapsuleCut spoilt = cut;
            spoil(spoilt.frame);
            appendWhole(scene.made.steps, spoilt, {path});
            PaintLabel other = paint;
            spoil(other.frame);
            appendWhole(scene.made.steps, other, {path});
        }
        scene.made.steps.push_back(command(core::BeginEdit{cut}));
        scene.made.steps.push_back(command(core::ExtendEdit{core::DrillPath{}}));
        scene.made.steps.push_back(command(core::ExtendEdit{core::GrowAdvance{}}));
        scene.made.steps.push_back(command(core::ExtendEdit{path}));
        scene.made.steps.push_back(command(core::EndEdit{}));
        scene.made.steps.push_back(command(core::ExtendEdit{path}));
        appendWhole(scene.made.steps, core::EraseLabel{.label = 1}, {path});
        add(scene);
    }
    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomPainting(number));
    return cases;
}

std::vector<EngineCase> carveCases(int randomCount)
{
    std::vector<EngineCase> cases;
    for (int number = 0; number < randomCount; ++number) {
        Random random(std::uint32_t(17000 + number));
        const glm::ivec3 size{
            randomInt(random, 1, 32), randomInt(random, 1, 32), randomInt(random, 1, 32)};
        Scene scene("random carving " + QByteArray::number(number), std::uint32_t(18000 + number),
            size, random() % 2);
        for (const bool restore : {false, true}) {
            BrushStroke stroke = randomBrush(scene.document, random);
            stroke.layer = 1;
            stroke.restore = restore;
            scene.append(stroke, random() % 8 ? core::Ending::Commit : core::Ending::Rollback);
        }
        cases.push_back(std::move(scene.made));
    }
    return cases;
}

} // namespace test
