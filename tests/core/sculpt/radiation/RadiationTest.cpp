// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/radiation/Radiation.h"
#include "tests/reference/fields/Radiation.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>

namespace radiationTest {

using test::Bytes;

namespace {

Bytes filled(const glm::ivec3& size, std::uint8_t value = 0)
{
    Bytes bytes{size, {}};
    bytes.values.assign(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), value);
    return bytes;
}

/// 255 where `inside` holds.
template <class Inside> Bytes shape(const glm::ivec3& size, Inside inside)
{
    Bytes bytes = filled(size);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                bytes.at({x, y, z}) = inside(glm::ivec3(x, y, z)) ? 255 : 0;
    return bytes;
}

/// The definition, one voxel, 343 terms, in units of 2⁻²⁴.
std::uint64_t sumAt(const Bytes& coverage, const glm::ivec3& centre)
{
    using namespace core::radiation;
    std::uint64_t sum = 0;
    for (int dz = -radius; dz <= radius; ++dz) {
        for (int dy = -radius; dy <= radius; ++dy) {
            for (int dx = -radius; dx <= radius; ++dx) {
                const glm::ivec3 voxel = centre + glm::ivec3(dx, dy, dz);
                if (coverage.contains(voxel))
                    sum += std::uint64_t(coverage.at(voxel)) * weights[std::size_t(dx + radius)]
                        * weights[std::size_t(dy + radius)] * weights[std::size_t(dz + radius)];
            }
        }
    }
    return sum;
}

std::uint32_t blurAt(const Bytes& coverage, const glm::ivec3& centre)
{
    return std::uint32_t((sumAt(coverage, centre) + (1u << 23)) >> 24);
}

/// Where radiation falls through one half between a member and the voxel after it, by linear
/// interpolation: voxels from the member's centre.
double crossing(const Bytes& radiation, const glm::ivec3& member, const glm::ivec3& outward)
{
    const double inside = radiation.at(member);
    const double outside = radiation.at(member + outward);
    return (inside - 128.0) / (inside - outside);
}

} // namespace

class RadiationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void neverHidesOrInventsAVoxel();
    void isTheSumOfItsDefinition();
    void isCloseToTheSumOfGaussians_data();
    void isCloseToTheSumOfGaussians();
    void leavesAFlatHalfSpaceToTheBlur_data();
    void leavesAFlatHalfSpaceToTheBlur();
    void thinPartsKeepAWidth_data();
    void thinPartsKeepAWidth();
    void changesStayWithinReach();
};

void RadiationTest::neverHidesOrInventsAVoxel()
{
    const int count = test::longRun() ? 300 : 30;
    for (int seed = 0; seed < count; ++seed) {
        test::Random random{std::uint32_t(seed)};
        const glm::ivec3 size{test::randomInt(random, 1, 24), test::randomInt(random, 1, 24),
            test::randomInt(random, 1, 24)};
        Bytes coverage = filled(size);
        const int density = test::randomInt(random, 1, 60);
        const auto codes = test::balls(size, 4, random);
        for (std::size_t i = 0; i < coverage.values.size(); ++i) {
            if (seed % 3 == 0) // any bytes at all, those around the border of membership most
                coverage.values[i] = std::uint8_t(random() % 2 ? test::randomInt(random, 0, 255)
                                                               : test::randomInt(random, 126, 129));
            else if (seed % 3 == 1) // dust
                coverage.values[i] = test::randomInt(random, 0, density) == 0 ? 255 : 0;
            else // shapes with a ramp
                coverage.values[i] = std::uint8_t(std::min(codes.values[i] / 4, 255));
        }
        const Bytes radiation = reference::radiation(coverage);
        for (std::size_t i = 0; i < coverage.values.size(); ++i)
            QCOMPARE(radiation.values[i] >= 128, coverage.values[i] >= 128);
    }
}

void RadiationTest::isTheSumOfItsDefinition()
{
    using namespace core::radiation;
    QCOMPARE(
        weights[0] + weights[1] + weights[2] + weights[3] + weights[4] + weights[5] + weights[6],
        256u);
    test::Random random(8);
    const glm::ivec3 size(13, 9, 11);
    Bytes coverage = filled(size);
    for (std::uint8_t& value : coverage.values)
        value = std::uint8_t(random() % 3 ? 0 : test::randomInt(random, 0, 255));
    const Bytes radiation = reference::radiation(coverage);
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                const int blur = int(blurAt(coverage, voxel));
                if (coverage.at(voxel) < 128) {
                    QCOMPARE(int(radiation.at(voxel)), std::min(blur, 127));
                    continue;
                }
                int greatest = 0;
                for (int i = 0; i < 27; ++i) {
                    const glm::ivec3 near = voxel + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
                    if (coverage.contains(near))
                        greatest = std::max(greatest, int(blurAt(coverage, near)));
                }
                int expected = std::max(blur, 128);
                if (greatest < thinBelow)
                    expected =
                        std::max(expected, 128 + thinLift * (thinBelow - greatest) / thinBelow);
                QCOMPARE(int(radiation.at(voxel)), expected);
            }
        }
    }
}

void RadiationTest::isCloseToTheSumOfGaussians_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("random bytes") << 0;
    QTest::newRow("dust") << 1;
    QTest::newRow("balls with a ramp") << 2;
    QTest::newRow("boxes") << 3;
    QTest::newRow("half-spaces") << 4;
}

void RadiationTest::isCloseToTheSumOfGaussians()
{
    QFETCH(int, kind);
    // Seed A's Gaussian, in doubles: σ = 1.198 (about R / 2.5), of sum 1, since a filled mask
    // reaches 1 inside. The difference is what weights in 1/256 make: along an axis they are off by
    // 0.0043 at most in sum, so no coverage can show more than 3.3 of 255. What has steep edges
    // along several axes reaches a third of that.
    std::array<double, 7> gaussian{};
    double total = 0.0;
    for (int i = -3; i <= 3; ++i) {
        gaussian[std::size_t(i + 3)] = std::exp(-0.5 * i * i / (1.198 * 1.198));
        total += gaussian[std::size_t(i + 3)];
    }
    double worst = 0.0;
    const int count = test::longRun() ? 60 : 6;
    for (int seed = 0; seed < count; ++seed) {
        test::Random random{std::uint32_t(40 + seed)};
        const glm::ivec3 size(16, 14, 12);
        Bytes coverage = filled(size);
        const auto codes = test::balls(size, 4, random);
        glm::ivec3 low;
        glm::ivec3 high;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = test::randomInt(random, 0, size[axis] - 1);
            high[axis] = test::randomInt(random, low[axis], size[axis] - 1);
        }
        const int axis = seed % 3;
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    const glm::ivec3 v(x, y, z);
                    const bool inBox = glm::all(glm::greaterThanEqual(v, low))
                        && glm::all(glm::lessThanEqual(v, high));
                    const std::array<int, 5> value{test::randomInt(random, 0, 255),
                        random() % 4 ? 0 : 255, std::min(codes.at(v) / 4, 255), inBox ? 255 : 0,
                        v[axis] >= low[axis] ? 255 : 0};
                    coverage.at(v) = std::uint8_t(value[std::size_t(kind)]);
                }
            }
        }
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    double sum = 0.0;
                    for (int i = 0; i < 343; ++i) {
                        const glm::ivec3 step(i % 7, i / 7 % 7, i / 49);
                        const glm::ivec3 near = glm::ivec3(x, y, z) + step - 3;
                        if (coverage.contains(near))
                            sum += coverage.at(near) * gaussian[std::size_t(step.x)]
                                * gaussian[std::size_t(step.y)] * gaussian[std::size_t(step.z)];
                    }
                    const double blur = double(sumAt(coverage, {x, y, z})) / double(1u << 24);
                    worst = std::max(worst, std::abs(blur - sum / (total * total * total)));
                }
            }
        }
    }
    qInfo("greatest difference %.2f of 255", worst);
    QVERIFY2(worst <= 1.5, qPrintable(QString::number(worst)));
}

void RadiationTest::leavesAFlatHalfSpaceToTheBlur_data()
{
    QTest::addColumn<int>("axis");
    QTest::addColumn<bool>("upper");
    for (int axis = 0; axis < 3; ++axis) {
        QTest::addRow("axis %d, lower", axis) << axis << false;
        QTest::addRow("axis %d, upper", axis) << axis << true;
    }
}

void RadiationTest::leavesAFlatHalfSpaceToTheBlur()
{
    QFETCH(int, axis);
    QFETCH(bool, upper);
    const glm::ivec3 size(20, 20, 20);
    const Bytes coverage =
        shape(size, [&](const glm::ivec3& v) { return (v[axis] >= 10) == upper; });
    const Bytes radiation = reference::radiation(coverage);
    // Away from the faces of the volume, where what lies outside counts as empty.
    for (int z = 4; z < 16; ++z)
        for (int y = 4; y < 16; ++y)
            for (int x = 4; x < 16; ++x)
                QCOMPARE(std::uint32_t(radiation.at({x, y, z})), blurAt(coverage, {x, y, z}));
    glm::ivec3 member(10, 10, 10);
    member[axis] = upper ? 10 : 9;
    glm::ivec3 outward(0);
    outward[axis] = upper ? -1 : 1;
    const double surface = crossing(radiation, member, outward);
    QVERIFY2(std::abs(surface - 0.5) < 0.02, qPrintable(QString::number(surface)));
}

void RadiationTest::thinPartsKeepAWidth_data()
{
    QTest::addColumn<int>("thickness");
    QTest::addColumn<int>("thinAxes");
    for (int axes = 1; axes <= 3; ++axes)
        for (int thickness = 1; thickness <= 3; ++thickness)
            QTest::addRow("%d voxels along %d axes", thickness, axes) << thickness << axes;
}

void RadiationTest::thinPartsKeepAWidth()
{
    QFETCH(int, thickness);
    QFETCH(int, thinAxes);
    // A sheet, a rod or a cube of so many voxels.
    const glm::ivec3 size(20, 20, 20);
    const Bytes coverage = shape(size, [&](const glm::ivec3& v) {
        for (int axis = 0; axis < thinAxes; ++axis) {
            if (v[axis] < 10 || v[axis] >= 10 + thickness)
                return false;
        }
        return true;
    });
    const Bytes radiation = reference::radiation(coverage);
    for (int axis = 0; axis < thinAxes; ++axis) {
        // Through the middle of the other axes, from the outermost voxel outwards.
        glm::ivec3 first(10 + thickness / 2);
        for (int other = thinAxes; other < 3; ++other)
            first[other] = 10;
        glm::ivec3 last = first;
        first[axis] = 10;
        last[axis] = 10 + thickness - 1;
        glm::ivec3 outward(0);
        outward[axis] = 1;
        const double below = crossing(radiation, first, -outward);
        const double above = crossing(radiation, last, outward);
        const double halfWidth = (below + above + (thickness - 1)) / 2.0;
        QVERIFY2(halfWidth >= 0.4, qPrintable(QString::number(halfWidth)));
        QVERIFY2(halfWidth <= thickness / 2.0 + 0.1, qPrintable(QString::number(halfWidth)));
    }
}

void RadiationTest::changesStayWithinReach()
{
    test::Random random(21);
    const glm::ivec3 size(20, 20, 20);
    Bytes coverage = filled(size);
    for (std::uint8_t& value : coverage.values)
        value = random() % 5 ? 0 : 255;
    const Bytes before = reference::radiation(coverage);
    const glm::ivec3 changed(10, 9, 11);
    coverage.at(changed) = coverage.at(changed) ? 0 : 255;
    const Bytes after = reference::radiation(coverage);
    bool differs = false;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 d = glm::abs(glm::ivec3(x, y, z) - changed);
                if (before.at({x, y, z}) == after.at({x, y, z}))
                    continue;
                differs = true;
                QVERIFY(std::max({d.x, d.y, d.z}) <= core::radiation::reach);
            }
        }
    }
    QVERIFY(differs);
}

BURIN_TEST(RadiationTest)

} // namespace radiationTest

#include "RadiationTest.moc"
