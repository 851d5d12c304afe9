// SPDX-License-Identifier: Apache-2.0
#include "core/refine/voxels/SmoothOccupancy.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

namespace smoothOccupancyTest {

namespace {

constexpr int one = 4096;

/// What the header says of a voxel's centre, worked out from the mask alone; one is inside.
int centreAt(const core::BoxMask& mask, const glm::ivec3& voxel)
{
    constexpr std::array<int, 3> once{1, 2, 1};
    constexpr std::array<int, 5> twice{1, 4, 6, 4, 1};
    int smooth = 0;
    int smoother = 0;
    for (int z = -2; z <= 2; ++z) {
        for (int y = -2; y <= 2; ++y) {
            for (int x = -2; x <= 2; ++x) {
                if (!mask.contains(voxel + glm::ivec3(x, y, z)))
                    continue;
                const auto weight = [&](const auto& weights, int reach) {
                    const auto at = [&](int i) {
                        return std::abs(i) <= reach ? weights[std::size_t(i + reach)] : 0;
                    };
                    return at(x) * at(y) * at(z);
                };
                smooth += weight(once, 1);
                smoother += weight(twice, 2);
            }
        }
    }
    const int sharp = 2 * 64 * smooth - smoother;
    return mask.contains(voxel) ? std::max(sharp, 11 * one / 16) : std::min(sharp, 5 * one / 16);
}

double fieldAt(const core::BoxMask& mask, const glm::dvec3& index)
{
    const glm::dvec3 low = glm::floor(index);
    const glm::dvec3 share = index - low;
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 offset(i & 1, (i >> 1) & 1, i >> 2);
        const glm::dvec3 weight = glm::mix(1.0 - share, share, glm::dvec3(offset));
        sum += weight.x * weight.y * weight.z * centreAt(mask, glm::ivec3(low) + offset);
    }
    return sum / one;
}

test::ShapedMask scattered(test::Random& random, int share)
{
    test::ShapedMask made({test::randomInt(random, 1, 20), test::randomInt(random, 1, 20),
        test::randomInt(random, 1, 20)});
    for (auto& label : made.labels)
        label = test::randomInt(random, 0, 99) < share ? 1 : 0;
    return made;
}

glm::dvec3 somewhere(test::Random& random)
{
    const auto along = [&] { return -8.0 + 36.0 * test::randomUnit(random); };
    return {along(), along(), along()};
}

} // namespace

/// The field is what its definition says, wherever one looks and in whichever order.
class SmoothOccupancyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void centres_data();
    void centres();
    void betweenCentres_data() { centres_data(); }
    void betweenCentres();
    void whoeverWalksReadsTheSame();
    void farAway();
};

void SmoothOccupancyTest::centres_data()
{
    QTest::addColumn<int>("share");
    for (const int share : {1, 30, 97, 100})
        QTest::addRow("%d %%", share) << share;
}

void SmoothOccupancyTest::centres()
{
    QFETCH(int, share);
    auto random = test::Random(std::uint64_t(share));
    const core::BoxMask mask = scattered(random, share).mask();
    const core::SmoothOccupancy field(mask);
    for (int z = -4; z < 24; ++z) {
        for (int y = -4; y < 24; ++y) {
            for (int x = -4; x < 24; ++x)
                QCOMPARE(field.at({x, y, z}), double(centreAt(mask, {x, y, z})) / one);
        }
    }
}

void SmoothOccupancyTest::betweenCentres()
{
    QFETCH(int, share);
    auto random = test::Random(std::uint64_t(1000 + share));
    const core::BoxMask mask = scattered(random, share).mask();
    const core::SmoothOccupancy field(mask);
    constexpr double step = 1.0 / 1024.0; // within a voxel the field is linear along each axis
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 at = somewhere(random);
        QVERIFY(std::abs(field.at(at) - fieldAt(mask, at)) < 1e-12);
        const glm::dvec3 rise = field.rise(at);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 next = at;
            next[axis] += std::floor(at[axis] + step) > std::floor(at[axis]) ? -step : step;
            const double slope =
                (fieldAt(mask, next) - fieldAt(mask, at)) / (next[axis] - at[axis]);
            QVERIFY(std::abs(rise[axis] - slope) < 1e-9);
        }
    }
}

void SmoothOccupancyTest::whoeverWalksReadsTheSame()
{
    auto random = test::Random(7);
    const core::BoxMask mask = scattered(random, 50).mask();
    const core::SmoothOccupancy field(mask);
    core::SmoothOccupancy::Walk walk(field);
    glm::dvec3 at = somewhere(random);
    for (int i = 0; i < 20'000; ++i) {
        QCOMPARE(walk.at(at), field.at(at));
        at = i % 50 == 0 ? somewhere(random) : at + 0.5 * (somewhere(random) - at) / 19.0;
    }
}

void SmoothOccupancyTest::farAway()
{
    auto random = test::Random(8);
    const core::BoxMask mask = scattered(random, 50).mask();
    const core::SmoothOccupancy field(mask);
    for (const double far : {-1e300, -3e9, -1e5, 1e5, 3e9, 1e300}) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 at(3.5);
            at[axis] = far;
            QCOMPARE(field.at(at), 0.0);
            QCOMPARE(field.rise(at), glm::dvec3(0.0));
        }
    }
    QCOMPARE(core::SmoothOccupancy(core::BoxMask()).at({1, 2, 3}), 0.0);
}

BURIN_TEST(SmoothOccupancyTest)

} // namespace smoothOccupancyTest

#include "SmoothOccupancyTest.moc"
