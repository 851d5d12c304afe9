// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/SegmentShape.h"

#include "core/morphology/MillimetreBall.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace segmentShapeTest {

namespace {

using core::ShapeOperation;
using core::ShellPlace;
using Labels = std::vector<std::uint8_t>;

double within(std::mt19937& random, double from, double to)
{
    return from + (to - from) * double(random()) / double(std::mt19937::max());
}

/// Axes of any direction and length; at right angles, unless they are sheared.
core::VolumeGeometry anyGrid(const glm::ivec3& size, bool sheared, std::mt19937& random)
{
    // In braces, since compilers differ in the order of a call's arguments.
    const auto some = [&](double from, double to) { return within(random, from, to); };
    const glm::dvec3 x =
        glm::normalize(glm::dvec3{some(0.2, 1.0), some(-1.0, 1.0), some(-1.0, 1.0)});
    const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(-x.y, x.x, 0.3)));
    const glm::dvec3 spacing{some(0.5, 1.6), some(0.5, 1.6), some(0.7, 3.0)};
    const glm::dvec3 shear{some(-1.2, 1.2), some(-0.4, 0.4), some(-0.3, 0.3)};
    glm::dmat3 axes(x * spacing.x, y * spacing.y, glm::cross(x, y) * spacing.z);
    if (sheared) {
        axes[2] += axes[1] * shear.x + axes[0] * shear.y;
        axes[1] += axes[0] * shear.z;
    }
    core::VolumeGeometry geometry;
    geometry.size = size;
    geometry.indexToWorld = glm::dmat4(axes);
    return geometry;
}

std::size_t indexOf(const glm::ivec3& at, const glm::ivec3& size)
{
    return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
        + std::size_t(at.x);
}

bool isIn(const glm::ivec3& at, const glm::ivec3& size)
{
    return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < size.x && at.y < size.y && at.z < size.z;
}

/// Blocks of the segment 1 with specks in and beside them, and a block of another one.
Labels anyMatter(const glm::ivec3& size, std::mt19937& random)
{
    Labels labels(std::size_t(size.x * size.y * size.z), 0);
    for (const int label : {1, 1, 1, 2}) {
        const glm::ivec3 one{int(random() & 31), int(random() & 31), int(random() & 31)};
        const glm::ivec3 other{int(random() & 31), int(random() & 31), int(random() & 31)};
        const glm::ivec3 from = glm::min(one % size, other % size);
        const glm::ivec3 to = glm::max(one % size, other % size);
        for (int z = from.z; z <= to.z; ++z) {
            for (int y = from.y; y <= to.y; ++y) {
                for (int x = from.x; x <= to.x; ++x)
                    labels[indexOf({x, y, z}, size)] = std::uint8_t(label);
            }
        }
    }
    for (std::uint8_t& label : labels) {
        if (random() % 25 == 0)
            label = label == 1 ? 0 : 1;
    }
    return labels;
}

/// Voxel against voxel, by their places in the patient.
class Oracle {
public:
    Oracle(const core::VolumeGeometry& geometry, const Labels& labels, double mm)
        : m_size(geometry.size)
        , m_labels(labels)
    {
        const glm::ivec3 all = m_size + 2 * far;
        m_nearOwn.assign(std::size_t(all.x * all.y * all.z), unknown);
        m_nearRest = m_nearOwn;
        for (int z = -far; z <= far; ++z) {
            for (int y = -far; y <= far; ++y) {
                for (int x = -far; x <= far; ++x) {
                    const glm::ivec3 step(x, y, z);
                    const double length = glm::length(
                        geometry.toWorld(glm::dvec3(step)) - geometry.toWorld(glm::dvec3(0.0)));
                    if (length <= mm * (1.0 + 4e-7))
                        m_steps.push_back(step);
                }
            }
        }
    }

    [[nodiscard]] const std::vector<glm::ivec3>& steps() const { return m_steps; }
    [[nodiscard]] bool isOwn(const glm::ivec3& at) const
    {
        return isIn(at, m_size) && m_labels[indexOf(at, m_size)] == 1;
    }
    [[nodiscard]] bool isRest(const glm::ivec3& at) const
    {
        return isIn(at, m_size) && m_labels[indexOf(at, m_size)] != 1;
    }
    template <class Is> [[nodiscard]] bool anyAround(const glm::ivec3& at, const Is& is) const
    {
        return std::any_of(
            m_steps.begin(), m_steps.end(), [&](const glm::ivec3& step) { return is(at + step); });
    }
    template <class Is> [[nodiscard]] bool isMajority(const glm::ivec3& at, const Is& is) const
    {
        const auto count = std::count_if(
            m_steps.begin(), m_steps.end(), [&](const glm::ivec3& step) { return is(at + step); });
        return 2 * std::size_t(count) > m_steps.size();
    }
    [[nodiscard]] bool nearOwn(const glm::ivec3& at) const
    {
        return known(m_nearOwn, at, [&] {
            return anyAround(at, [this](const glm::ivec3& other) { return isOwn(other); });
        });
    }
    [[nodiscard]] bool nearRest(const glm::ivec3& at) const
    {
        return known(m_nearRest, at, [&] {
            return anyAround(at, [this](const glm::ivec3& other) { return isRest(other); });
        });
    }
    /// Whether the voxel becomes the segment's, or stays it.
    [[nodiscard]] bool isOwnAfter(
        ShapeOperation operation, ShellPlace place, const glm::ivec3& at) const
    {
        const bool own = isOwn(at);
        switch (operation) {
        case ShapeOperation::Grow:
            return nearOwn(at);
        case ShapeOperation::Shrink:
            return own && !nearRest(at);
        case ShapeOperation::Hollow:
            return own ? place != ShellPlace::Outside && nearRest(at)
                       : place != ShellPlace::Inside && nearOwn(at);
        case ShapeOperation::Open:
            return own && anyAround(at, [this](const glm::ivec3& centre) {
                return isIn(centre, m_size) && !nearRest(centre);
            });
        case ShapeOperation::Close:
            return own
                || !anyAround(at, [this](const glm::ivec3& centre) { return !nearOwn(centre); });
        case ShapeOperation::Median:
            return own ? !isMajority(at, [this](const glm::ivec3& other) { return isRest(other); })
                       : isMajority(at, [this](const glm::ivec3& other) { return isOwn(other); });
        case ShapeOperation::Wrap:
            return own || !anyAround(at, [this](const glm::ivec3& centre) {
                return isReachedFromOutside(centre);
            });
        case ShapeOperation::Gaussian:
            break; // GaussianShapeTest
        }
        return own;
    }

private:
    /// An answer that is given often; also for places beside the volume.
    template <class Answer>
    [[nodiscard]] bool known(
        std::vector<int>& answers, const glm::ivec3& at, const Answer& answer) const
    {
        int& its = answers[indexOf(at + far, m_size + 2 * far)];
        if (its == unknown)
            its = answer() ? 1 : 0;
        return its == 1;
    }

    /// Whether the ball's centre can come here from far away, voxel by voxel, without the ball's
    /// ever holding one of the segment.
    [[nodiscard]] bool isReachedFromOutside(const glm::ivec3& at) const
    {
        if (m_reached.empty())
            floodFromOutside();
        const glm::ivec3 place = at + m_rim;
        return !isIn(place, m_size + 2 * m_rim)
            || m_reached[indexOf(place, m_size + 2 * m_rim)] != 0;
    }
    void floodFromOutside() const
    {
        m_rim = glm::ivec3(1);
        for (const glm::ivec3& step : m_steps)
            m_rim = glm::max(m_rim, glm::abs(step) + 1);
        const glm::ivec3 all = m_size + 2 * m_rim;
        m_reached.assign(std::size_t(all.x * all.y * all.z), 0);
        std::vector<glm::ivec3> next{glm::ivec3(0)}; // a corner, where nothing is
        while (!next.empty()) {
            const glm::ivec3 place = next.back();
            next.pop_back();
            if (!isIn(place, all) || m_reached[indexOf(place, all)] != 0 || nearOwn(place - m_rim))
                continue;
            m_reached[indexOf(place, all)] = 1;
            for (const glm::ivec3& step :
                {glm::ivec3(1, 0, 0), glm::ivec3(0, 1, 0), glm::ivec3(0, 0, 1)}) {
                next.push_back(place + step);
                next.push_back(place - step);
            }
        }
    }

    static constexpr int far = 24; ///< no ball here reaches so many voxels
    static constexpr int unknown = -1;
    glm::ivec3 m_size;
    const Labels& m_labels;
    std::vector<glm::ivec3> m_steps;
    mutable std::vector<int> m_nearOwn;
    mutable std::vector<int> m_nearRest;
    mutable std::vector<char> m_reached;
    mutable glm::ivec3 m_rim{1}; ///< around the volume, in m_reached
};

Labels after(const Labels& labels, const core::ShapeChange& change)
{
    Labels now = labels;
    for (const core::VoxelRun& run : change.given.runs())
        std::fill_n(now.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(1));
    for (const core::VoxelRun& run : change.taken.runs())
        std::fill_n(now.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(0));
    return now;
}

core::Result<core::ShapeChange> shaped(const core::VolumeGeometry& geometry, const Labels& labels,
    ShapeOperation operation, double mm, const core::Progress& progress = core::Progress())
{
    return core::shapeChange(labels, geometry.size, 1, operation, ShellPlace::Inside,
        core::ballOf(geometry, mm), progress);
}

core::VolumeGeometry plainGrid(const glm::ivec3& size, const glm::dvec3& spacing)
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    geometry.indexToWorld = glm::dmat4(glm::dmat3(glm::dvec3(spacing.x, 0.0, 0.0),
        glm::dvec3(0.0, spacing.y, 0.0), glm::dvec3(0.0, 0.0, spacing.z)));
    return geometry;
}

} // namespace

/// The shape of a segment after each operation, held to every voxel against every other.
class SegmentShapeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void randomMatter_data()
    {
        QTest::addColumn<int>("operation");
        QTest::addColumn<int>("place");
        QTest::addColumn<bool>("sheared");
        for (const bool sheared : {false, true}) {
            for (int operation = 0; operation < 7; ++operation) {
                const int places = ShapeOperation(operation) == ShapeOperation::Hollow ? 3 : 1;
                for (int place = 0; place < places; ++place)
                    QTest::addRow(
                        "operation %d, place %d%s", operation, place, sheared ? ", sheared" : "")
                        << operation << place << sheared;
            }
        }
    }
    void randomMatter()
    {
        QFETCH(const int, operation);
        QFETCH(const int, place);
        QFETCH(const bool, sheared);
        std::mt19937 random(std::uint32_t(100 * operation + 10 * place + (sheared ? 1 : 0)));
        const std::array<glm::ivec3, 5> sizes{
            glm::ivec3(12, 11, 9), {1, 12, 7}, {20, 1, 6}, {17, 6, 1}, {19, 8, 6}};
        std::size_t changed = 0;
        for (const glm::ivec3& size : sizes) {
            for (const double most : {1.2, 2.5, 4.5}) {
                const core::VolumeGeometry geometry = anyGrid(size, sheared, random);
                const Labels labels = anyMatter(size, random);
                const double mm = within(random, 0.4 * most, most);
                const core::MillimetreBall ball = core::ballOf(geometry, mm);
                QCOMPARE(ball.isStraight(), !sheared);
                const auto change = core::shapeChange(labels, size, 1, ShapeOperation(operation),
                    ShellPlace(place), ball, core::Progress());
                QVERIFY(change);
                const Oracle oracle(geometry, labels, mm);
                Labels expected = labels;
                for (int z = 0; z < size.z; ++z) {
                    for (int y = 0; y < size.y; ++y) {
                        for (int x = 0; x < size.x; ++x) {
                            std::uint8_t& label = expected[indexOf({x, y, z}, size)];
                            const bool own = oracle.isOwnAfter(
                                ShapeOperation(operation), ShellPlace(place), {x, y, z});
                            if (label != 2) // another segment's voxels stay its own
                                label = own ? 1 : 0;
                        }
                    }
                }
                QVERIFY(after(labels, *change) == expected);
                changed += change->given.voxelCount() + change->taken.voxelCount();
                QCOMPARE(core::voxelCount(ball), std::int64_t(oracle.steps().size()));
            }
        }
        QVERIFY2(changed > 100, qPrintable(QString::number(changed)));
    }

    /// In a single slice the ball is a disc, which holes and spurs of a pixel do not fill by half:
    /// of a ball most voxels would lie beside the slice.
    void aSingleSliceIsSmoothed()
    {
        const glm::ivec3 size(20, 20, 1);
        const core::VolumeGeometry geometry = plainGrid(size, glm::dvec3(1.0));
        Labels labels(std::size_t(size.x * size.y * size.z), 0);
        for (int y = 5; y < 15; ++y) {
            for (int x = 5; x < 15; ++x)
                labels[indexOf({x, y, 0}, size)] = 1;
        }
        const std::size_t hole = indexOf({9, 10, 0}, size);
        const std::size_t spur = indexOf({15, 9, 0}, size);
        labels[hole] = 0;
        labels[spur] = 1;
        const auto majority = [&](const core::MillimetreBall& ball) {
            return core::shapeChange(labels, size, 1, ShapeOperation::Median, ShellPlace::Inside,
                ball, core::Progress());
        };
        // As sessions of before have it: most of the ball is never there.
        const auto whole = majority(core::ballOf(geometry, 1.5));
        QVERIFY(whole && after(labels, *whole) == labels);
        const auto change = majority(core::flatBallOf(geometry, 1.5));
        QVERIFY(change);
        Labels expected = labels;
        expected[hole] = 1;
        expected[spur] = 0;
        for (const int y : {5, 14}) {
            for (const int x : {5, 14})
                expected[indexOf({x, y, 0}, size)] = 0; // the block's corners
        }
        QVERIFY(after(labels, *change) == expected);
    }

    /// A radius that is a whole number of voxels reaches the last of them, whatever their spacing
    /// is as a floating-point number.
    void aRadiusOfWholeVoxels_data()
    {
        QTest::addColumn<double>("spacing");
        for (const double spacing : {0.1, 0.3, 1.0 / 3.0, 0.488281, 0.7, 1.1, 3.0000001, 1e-3})
            QTest::addRow("%.9g mm", spacing) << spacing;
    }
    void aRadiusOfWholeVoxels()
    {
        QFETCH(const double, spacing);
        const glm::ivec3 size(15, 15, 15);
        const core::VolumeGeometry geometry =
            plainGrid(size, glm::dvec3(spacing, spacing * 2.0, spacing / 3.0));
        Labels labels(std::size_t(size.x * size.y * size.z), 0);
        labels[indexOf({7, 7, 7}, size)] = 1;
        for (int axis = 0; axis < 3; ++axis) {
            for (int voxels = 1; voxels <= 6; ++voxels) {
                const double mm = voxels * geometry.spacingMm()[axis];
                const auto change = shaped(geometry, labels, ShapeOperation::Grow, mm);
                QVERIFY(change);
                const Labels now = after(labels, *change);
                for (const int direction : {-1, 1}) {
                    glm::ivec3 last(7);
                    last[axis] += direction * voxels;
                    glm::ivec3 next = last;
                    next[axis] += direction;
                    QCOMPARE(int(now[indexOf(last, size)]), 1);
                    QCOMPARE(int(now[indexOf(next, size)]), 0);
                }
            }
        }
    }

    /// What touches the image's border does not shrink away from it, and a closing does not cling
    /// to it.
    void theBorderOfTheImage()
    {
        const glm::ivec3 size(12, 10, 10);
        const core::VolumeGeometry geometry = plainGrid(size, glm::dvec3(1.0));
        Labels slab(std::size_t(size.x * size.y * size.z), 0);
        Labels plate = slab;
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < 6; ++x)
                    slab[indexOf({x, y, z}, size)] = 1;
                plate[indexOf({2, y, z}, size)] = 1;
            }
        }
        const auto shrunk = shaped(geometry, slab, ShapeOperation::Shrink, 2.0);
        QVERIFY(shrunk);
        QCOMPARE(shrunk->taken.voxelCount(), std::uint64_t(2 * size.y * size.z));
        const auto opened = shaped(geometry, slab, ShapeOperation::Open, 4.0);
        QVERIFY(opened && opened->taken.empty());
        const auto closed = shaped(geometry, plate, ShapeOperation::Close, 4.0);
        QVERIFY(closed && closed->given.empty());
    }

    void nothingIsNothing()
    {
        const glm::ivec3 size(5, 4, 3);
        const core::VolumeGeometry geometry = plainGrid(size, glm::dvec3(1.0));
        const Labels others(std::size_t(size.x * size.y * size.z), 2);
        for (int operation = 0; operation < 7; ++operation) {
            const auto change = shaped(geometry, others, ShapeOperation(operation), 2.0);
            QVERIFY(change && change->given.empty() && change->taken.empty());
        }
    }

    /// Told of in order and to the end; when it is cancelled on the way, nothing comes of it.
    void progressAndCancelling_data()
    {
        QTest::addColumn<bool>("sheared");
        QTest::newRow("straight") << false;
        QTest::newRow("sheared") << true;
    }
    void progressAndCancelling()
    {
        QFETCH(const bool, sheared);
        std::mt19937 random(7);
        const core::VolumeGeometry geometry = anyGrid({40, 40, 40}, sheared, random);
        const Labels labels = anyMatter(geometry.size, random);
        for (int operation = 0; operation < 7; ++operation) {
            int last = 0;
            bool ordered = true;
            const core::Progress progress([&](core::ProgressStep step, int done, int total) {
                ordered = ordered && step == core::ProgressStep::ReshapingSegment && done > last
                    && done <= total;
                last = done == total ? -1 : done;
            });
            QVERIFY(shaped(geometry, labels, ShapeOperation(operation), 3.0, progress));
            QVERIFY(ordered);
            QCOMPARE(last, -1);

            core::Progress* mine = nullptr;
            core::Progress stopped([&](core::ProgressStep, int, int) { mine->cancel(); });
            mine = &stopped;
            const auto given = shaped(geometry, labels, ShapeOperation(operation), 3.0, stopped);
            QVERIFY(!given);
            QVERIFY(given.error().code == core::ErrorCode::Cancelled);
        }
    }

    /// A closing that would need a box far beyond the volume says so before it takes memory.
    void tooMuchMemory()
    {
        const glm::ivec3 size(64, 64, 64);
        const core::VolumeGeometry geometry = plainGrid(size, glm::dvec3(0.025));
        Labels labels(std::size_t(size.x * size.y * size.z), 0);
        labels[indexOf({30, 30, 30}, size)] = 1;
        const auto closed = shaped(geometry, labels, ShapeOperation::Close, 100.0);
        QVERIFY(!closed);
        QVERIFY(closed.error().code == core::ErrorCode::OutOfMemory);
        QVERIFY2(closed.error().arguments.front().contains(QLatin1String(" needs ")),
            qPrintable(closed.error().arguments.front()));
        const auto grown = shaped(geometry, labels, ShapeOperation::Grow, 100.0);
        QVERIFY(grown);
        QCOMPARE(grown->given.voxelCount(), std::uint64_t(64 * 64 * 64 - 1));
    }
};

BURIN_TEST(SegmentShapeTest)

} // namespace segmentShapeTest

#include "SegmentShapeTest.moc"
