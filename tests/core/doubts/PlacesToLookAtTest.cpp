// SPDX-License-Identifier: Apache-2.0
#include "core/doubts/PlacesToLookAt.h"

#include "core/brick/LabelRuns.h"
#include "core/doubts/MaskDisagreement.h"
#include "core/islands/VoxelIslands.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace placesToLookAtTest {

using core::BorderSource;
using core::DoubtfulPlace;
using core::FaintBorder;
using core::VoxelRuns;
using Why = core::DoubtfulPlace::Why;

namespace {

using Where = std::function<bool(const glm::dvec3&)>;
using Value = std::function<int(const glm::dvec3&)>;

const glm::dvec3 middle(30.0);
constexpr double radiusMm = 22.0;
constexpr int bright = 2000;
constexpr int dark = 1200;

bool inOrgan(const glm::dvec3& place)
{
    return glm::length(place - middle) <= radiusMm;
}

int organValue(const glm::dvec3& place)
{
    return inOrgan(place) ? bright : dark;
}

/// A volume with a segment of label 1, by places in mm.
struct Scene {
    core::VolumeGeometry geometry;
    std::vector<std::uint8_t> labels;
    std::vector<std::uint16_t> codes; ///< of the whole volume
    core::VoxelBox box;
    std::vector<std::uint16_t> boxCodes;

    /// @param noise values are off by as much at most
    Scene(const glm::ivec3& size, const glm::dvec3& spacing, const Where& isMasked,
        const Value& value, int noise)
    {
        geometry.size = size;
        for (int axis = 0; axis < 3; ++axis)
            geometry.indexToWorld[axis][axis] = spacing[axis];
        std::mt19937 random{3};
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    const glm::dvec3 place = glm::dvec3(x, y, z) * spacing;
                    labels.push_back(isMasked(place) ? 1 : 0);
                    codes.push_back(std::uint16_t(
                        value(place) - noise + int(random() % unsigned(2 * noise + 1))));
                }
            }
        }
        cutOut();
    }
    Scene(const glm::ivec3& size, std::vector<std::uint8_t> itsLabels,
        std::vector<std::uint16_t> itsCodes)
        : labels(std::move(itsLabels))
        , codes(std::move(itsCodes))
    {
        geometry.size = size;
        cutOut();
    }

    [[nodiscard]] BorderSource source() const
    {
        return {.geometry = geometry, .labels = labels, .label = 1, .box = box, .codes = boxCodes};
    }
    [[nodiscard]] std::vector<DoubtfulPlace> places(const VoxelRuns* second = nullptr) const
    {
        return *core::placesToLookAt(source(), second, 8, {});
    }
    [[nodiscard]] std::uint8_t labelAt(const glm::ivec3& at) const
    {
        return labels[std::size_t((at.z * geometry.size.y + at.y) * geometry.size.x + at.x)];
    }

private:
    void cutOut()
    {
        const glm::ivec3& size = geometry.size;
        box = core::boxAroundBorder(labels, size, 1);
        for (int z = box.minimum.z; z < box.maximum.z; ++z) {
            for (int y = box.minimum.y; y < box.maximum.y; ++y) {
                const auto row = codes.begin() + (z * size.y + y) * size.x;
                boxCodes.insert(boxCodes.end(), row + box.minimum.x, row + box.maximum.x);
            }
        }
    }
};

/// The usual size, 60 mm in each direction.
Scene organScene(const Where& isMasked, int noise, const Value& value = organValue)
{
    return Scene(glm::ivec3(60), glm::dvec3(1.0), isMasked, value, noise);
}

/// The sum of the directions in which the other voxels beside it lie.
glm::dvec3 outward(const Scene& scene, const glm::ivec3& at)
{
    glm::dvec3 sum(0.0);
    for (const glm::ivec3& way : {glm::ivec3(1, 0, 0), glm::ivec3(-1, 0, 0), glm::ivec3(0, 1, 0),
             glm::ivec3(0, -1, 0), glm::ivec3(0, 0, 1), glm::ivec3(0, 0, -1)}) {
        const glm::ivec3 to = at + way;
        const bool isIn = glm::all(glm::greaterThanEqual(to, glm::ivec3(0)))
            && glm::all(glm::lessThan(to, scene.geometry.size));
        if (isIn && scene.labelAt(to) != 1)
            sum += glm::dvec3(way);
    }
    return sum;
}

/// Of a place from a line through 0; 0 if the line has no direction.
double distanceToLine(const glm::ivec3& place, const glm::dvec3& direction)
{
    if (direction == glm::dvec3(0.0))
        return 0.0;
    return glm::length(glm::cross(glm::dvec3(place), glm::normalize(direction)));
}

/// Whether one of the first three leads to a place.
bool leadsTo(
    const std::vector<DoubtfulPlace>& places, Why why, const glm::dvec3& place, double withinMm)
{
    const auto end = places.begin() + std::ptrdiff_t(std::min<std::size_t>(3, places.size()));
    return std::any_of(places.begin(), end, [&](const DoubtfulPlace& each) {
        return each.why == why && glm::distance(each.placeLps, place) <= withinMm;
    });
}

bool hasOther(const Scene& scene, const glm::ivec3& at)
{
    for (int axis = 0; axis < 3; ++axis) {
        for (const int way : {-1, 1}) {
            glm::ivec3 beside = at;
            beside[axis] += way;
            if (beside[axis] >= 0 && beside[axis] < scene.geometry.size[axis]
                && scene.labelAt(beside) != 1)
                return true;
        }
    }
    return false;
}

} // namespace

/// Where the user is led to in a mask that some program made.
class PlacesToLookAtTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void noise_data()
    {
        QTest::addColumn<int>("noise");
        QTest::newRow("none") << 0;
        QTest::newRow("some") << 100;
        QTest::newRow("as the edge is high") << 800;
    }

    void aMissingLobe_data() { noise_data(); }
    void aMissingLobe()
    {
        QFETCH(int, noise);
        const Scene scene =
            organScene([](const glm::dvec3& at) { return inOrgan(at) && at.x >= 18.0; }, noise);
        const std::vector<DoubtfulPlace> places = scene.places();
        QVERIFY(leadsTo(places, Why::NoEdge, {18.0, 30.0, 30.0}, 4.0));
        // A disc of radius 18.4 mm, less its rim, where the outside is dark.
        const double area = places.front().areaMm2;
        QVERIFY2(area > 600.0 && area < 1100.0, qPrintable(QString::number(area)));
        QCOMPARE(scene.labelAt(places.front().voxel), std::uint8_t(1));
        QCOMPARE(places.front().placeLps, glm::dvec3(places.front().voxel));
    }

    /// A bump on the organ that is not there, and a bite out of it.
    void aBumpAndABite_data() { noise_data(); }
    void aBumpAndABite()
    {
        QFETCH(int, noise);
        const glm::dvec3 bump(30.0, 52.0, 30.0);
        const glm::dvec3 bite(30.0, 30.0, 8.0);
        const Scene scene = organScene(
            [&](const glm::dvec3& at) {
                return (inOrgan(at) && glm::length(at - bite) > 9.0)
                    || glm::length(at - bump) <= 9.0;
            },
            noise);
        const std::vector<DoubtfulPlace> places = scene.places();
        QVERIFY(leadsTo(places, Why::NoEdge, bump, 12.0));
        QVERIFY(leadsTo(places, Why::NoEdge, bite, 12.0));
    }

    /// Thick slices: there the border is compared across one slice.
    void thickSlices()
    {
        const Scene scene(
            {60, 60, 20}, glm::dvec3(1.0, 1.0, 3.0),
            [](const glm::dvec3& at) { return inOrgan(at) && at.z < 42.0; }, organValue, 100);
        QVERIFY(leadsTo(scene.places(), Why::NoEdge, {30.0, 30.0, 39.0}, 6.0));
    }

    /// A vessel that goes on, where the mask ends: the end is thinner than what is looked at.
    void aBrokenVessel_data()
    {
        QTest::addColumn<int>("noise");
        QTest::newRow("none") << 0;
        QTest::newRow("some") << 100;
        QTest::newRow("half as the edge is high") << 400;
    }
    void aBrokenVessel()
    {
        QFETCH(int, noise);
        const auto inVessel = [](const glm::dvec3& at) {
            return std::hypot(at.x - 30.0, at.y - 30.0) <= 4.0;
        };
        const Scene scene =
            organScene([&](const glm::dvec3& at) { return inVessel(at) && at.z < 40.0; }, noise,
                [&](const glm::dvec3& at) { return inVessel(at) ? bright : dark; });
        const std::vector<DoubtfulPlace> places = scene.places();
        QVERIFY(leadsTo(places, Why::NoEdge, {30.0, 30.0, 39.0}, 2.0));
        QCOMPARE(places.size(), std::size_t(1));
    }

    /// A mask without errors has few places or none, also where one neighbour is brighter and the
    /// other darker, and where the mask is a voxel too large or too small.
    void nothingStandsOut_data()
    {
        QTest::addColumn<double>("off");
        QTest::addColumn<bool>("brightBelow");
        QTest::addColumn<int>("noise");
        QTest::addColumn<int>("most");
        QTest::newRow("clean") << 0.0 << false << 0 << 0;
        QTest::newRow("noise") << 0.0 << false << 100 << 0;
        QTest::newRow("much noise") << 0.0 << false << 800 << 2;
        QTest::newRow("two neighbours") << 0.0 << true << 100 << 0;
        QTest::newRow("too large") << 1.0 << false << 100 << 0;
        QTest::newRow("too small") << -1.0 << false << 100 << 0;
    }
    void nothingStandsOut()
    {
        QFETCH(double, off);
        QFETCH(bool, brightBelow);
        QFETCH(int, noise);
        QFETCH(int, most);
        const Scene scene = organScene(
            [&](const glm::dvec3& at) { return glm::length(at - middle) <= radiusMm + off; }, noise,
            [&](const glm::dvec3& at) {
                return inOrgan(at) ? bright : brightBelow && at.z < 30.0 ? 2 * bright - dark : dark;
            });
        const std::size_t count = scene.places().size();
        QVERIFY2(count <= std::size_t(most), qPrintable(QString::number(count)));
    }

    /// A second mask that lacks a part, has one more, and is a voxel larger all around: the skin is
    /// no place.
    void disagreements()
    {
        const glm::dvec3 lobe(8.0, 30.0, 30.0);
        const glm::dvec3 beyond(30.0, 30.0, 54.0);
        const Scene mine = organScene(inOrgan, 100);
        const Scene theirs = organScene(
            [&](const glm::dvec3& at) {
                return (glm::length(at - middle) <= radiusMm + 1.0 && at.x >= 16.0)
                    || glm::length(at - beyond) <= 5.0;
            },
            100);
        const VoxelRuns second = core::labelRuns(theirs.labels, 1);
        const std::vector<DoubtfulPlace> places = mine.places(&second);
        QCOMPARE(places.size(), std::size_t(2));
        QVERIFY(leadsTo(places, Why::OnlyHere, lobe, 8.0));
        QVERIFY(leadsTo(places, Why::OnlyThere, beyond, 4.0));
        QCOMPARE(places.front().why, Why::OnlyHere);
        // A cap of 8 mm less its foremost voxels; it is all of the cap but thin edges.
        double cap = 0.0;
        for (int x = 0; x < 16; ++x) {
            for (int y = 0; y < 60; ++y) {
                for (int z = 0; z < 60; ++z)
                    cap += inOrgan(glm::dvec3(x, y, z)) ? 1.0 : 0.0;
            }
        }
        QVERIFY(places.front().volumeMm3 <= cap && places.front().volumeMm3 > 0.8 * cap);
        // Where the segment itself lacks the lobe, that is told once.
        const Scene lacking =
            organScene([](const glm::dvec3& at) { return inOrgan(at) && at.x >= 16.0; }, 100);
        const VoxelRuns whole = core::labelRuns(mine.labels, 1);
        const std::vector<DoubtfulPlace> told = lacking.places(&whole);
        QCOMPARE(told.size(), std::size_t(1));
        QCOMPARE(told.front().why, Why::OnlyThere);
        // An empty reference says nothing.
        const VoxelRuns none;
        QVERIFY(mine.places(&none).empty());
    }

    /// A mask that ends one thick slice too early differs in a single slice.
    void aSliceIsNoSkin()
    {
        core::VolumeGeometry geometry;
        geometry.size = {20, 20, 6};
        geometry.indexToWorld[2][2] = 5.0;
        VoxelRuns mine;
        VoxelRuns theirs;
        for (std::uint64_t row = 0; row < 120; ++row) {
            mine.append(row * 20 + 5, 10);
            if (row < 100)
                theirs.append(row * 20 + 5, 10);
        }
        const auto parts = core::onlyIn(mine, theirs, geometry, {});
        QVERIFY(parts.has_value());
        QCOMPARE(parts->size(), std::size_t(1));
        QCOMPARE(parts->front().voxels, std::int64_t(200));
        QVERIFY(core::onlyIn(theirs, mine, geometry, {})->empty());
        // With slices as near as the voxels it is a skin.
        geometry.indexToWorld[2][2] = 1.0;
        QVERIFY(core::onlyIn(mine, theirs, geometry, {})->empty());
    }

    /// Contrast, areas and parts of random masks as the class says them.
    void asDescribed()
    {
        std::mt19937 random{17};
        std::size_t told = 0;
        int compared = 0;
        for (int round = 0; round < 40; ++round) {
            const glm::ivec3 size(9 + int(random() % 6), 9 + int(random() % 6), 8);
            std::vector<std::uint8_t> labels;
            std::vector<std::uint16_t> codes;
            for (int at = 0; at < size.x * size.y * size.z; ++at) {
                const int x = at % size.x;
                const int z = at / size.x / size.y;
                labels.push_back(x > 3 && x < 7 && z > 1 && z < 6 ? 1 : 0);
                if (random() % 40 == 0)
                    labels.back() = std::uint8_t(random() % 3);
                // To the right of the mask there is no edge.
                const bool isBright = x > 3 && z > 1 && z < 6;
                codes.push_back(std::uint16_t((isBright ? 900 : 100) + int(random() % 40)));
            }
            const Scene scene(size, labels, codes);
            const auto faint = FaintBorder::of(scene.source(), {});
            QVERIFY(faint.has_value());
            struct Seen {
                glm::ivec3 at;
                double contrast;
            };
            std::vector<Seen> border;
            double area = 0.0;
            for (int at = 0; at < size.x * size.y * size.z; ++at) {
                const glm::ivec3 voxel(at % size.x, at / size.x % size.y, at / size.x / size.y);
                if (scene.labelAt(voxel) != 1 || !hasOther(scene, voxel))
                    continue;
                border.push_back({voxel, contrastAt(scene, voxel)});
                area += 1.0;
            }
            // Each has one to three faces' worth of area.
            QVERIFY(double(faint->wholeAreaUm2) >= area * 1e6
                && double(faint->wholeAreaUm2) <= area * 2e6 * std::sqrt(3.0));
            std::vector<double> contrasts;
            for (const Seen& seen : border)
                contrasts.push_back(seen.contrast);
            std::sort(contrasts.begin(), contrasts.end());
            const double limit = contrasts[contrasts.size() / 2] / 4.0;
            // Whole numbers are off by an eighth of a code or two.
            VoxelRuns expected;
            bool isClear = true;
            for (const Seen& seen : border) {
                isClear = isClear && std::abs(seen.contrast - limit) > 0.5;
                if (seen.contrast < limit)
                    expected.append(
                        std::uint64_t((seen.at.z * size.y + seen.at.y) * size.x + seen.at.x), 1);
            }
            if (!isClear)
                continue;
            ++compared;
            VoxelRuns large;
            const auto islands = core::islandsOf(expected, size, 9, {});
            for (const VoxelRuns& island : *islands)
                large = core::united(large, island);
            VoxelRuns all;
            for (const FaintBorder::Part& part : faint->parts) {
                QVERIFY(part.doubt > 0 && part.doubt <= part.areaUm2);
                all = core::united(all, part.voxels);
            }
            QVERIFY(all == large);
            told += std::size_t(all.voxelCount());
        }
        QVERIFY2(compared > 20, qPrintable(QString::number(compared)));
        QVERIFY2(told > 300, qPrintable(QString::number(told)));
    }

    void emptyAndFull()
    {
        const Scene empty = organScene([](const glm::dvec3&) { return false; }, 0);
        QVERIFY(empty.box.empty());
        QVERIFY(empty.places().empty());
        const VoxelRuns second = core::labelRuns(organScene(inOrgan, 0).labels, 1);
        QVERIFY(empty.places(&second).empty());
        // What fills the volume has no border.
        const Scene full = organScene([](const glm::dvec3&) { return true; }, 50);
        QVERIFY(full.places().empty());
        // One voxel is too few to be a place.
        const Scene one = organScene([](const glm::dvec3& at) { return at == middle; }, 50);
        QVERIFY(one.places().empty());
    }

    void theSameEachTimeAndNoMoreThanAsked()
    {
        const Scene scene = organScene(
            [](const glm::dvec3& at) { return inOrgan(at) && at.x >= 18.0 && at.y < 44.0; }, 400);
        const std::vector<DoubtfulPlace> places = scene.places();
        QVERIFY(places == scene.places());
        QVERIFY(places.size() >= 1 && places.size() <= 8);
        QCOMPARE(core::placesToLookAt(scene.source(), nullptr, 1, {})->size(), std::size_t(1));
    }

    void cancelled()
    {
        const Scene scene = organScene(inOrgan, 0);
        const VoxelRuns second = core::labelRuns(
            organScene([](const glm::dvec3& at) { return inOrgan(at) && at.x > 20.0; }, 0).labels,
            1);
        core::Progress progress;
        progress.cancel();
        for (const VoxelRuns* mask : {static_cast<const VoxelRuns*>(nullptr), &second}) {
            const auto places = core::placesToLookAt(scene.source(), mask, 8, progress);
            QVERIFY(!places);
            QCOMPARE(places.error().code, core::ErrorCode::Cancelled);
        }
    }

private:
    /// In codes, by the words of FaintBorder.
    static double contrastAt(const Scene& scene, const glm::ivec3& at)
    {
        std::vector<double> inside;
        std::vector<double> outside;
        for (int z = at.z - 2; z <= at.z + 2; ++z) {
            for (int y = at.y - 2; y <= at.y + 2; ++y) {
                for (int x = at.x - 2; x <= at.x + 2; ++x) {
                    const glm::ivec3 near(x, y, z);
                    const glm::ivec3& size = scene.geometry.size;
                    if (glm::any(glm::lessThan(near, glm::ivec3(0)))
                        || glm::any(glm::greaterThanEqual(near, size)))
                        continue;
                    const double aside = distanceToLine(near - at, outward(scene, at));
                    if (aside > 1.5 + 1e-9)
                        continue;
                    (scene.labelAt(near) == 1 ? inside : outside)
                        .push_back(scene.codes[std::size_t((z * size.y + y) * size.x + x)]);
                }
            }
        }
        const auto mean = [](const std::vector<double>& values) {
            double sum = 0.0;
            for (const double value : values)
                sum += value;
            return sum / double(values.size());
        };
        const double inner = mean(inside);
        const double apart = std::abs(inner - mean(outside));
        for (double& value : inside)
            value = std::abs(value - inner);
        for (double& value : outside)
            value = std::abs(value - inner);
        return std::max(apart, mean(outside) - mean(inside));
    }
};

BURIN_TEST(PlacesToLookAtTest)

} // namespace placesToLookAtTest

#include "PlacesToLookAtTest.moc"
