// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/FollowBoundary.h"
#include "core/refine/repair/SelfIntersections.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <cmath>

namespace followBoundaryTest {

namespace {

constexpr glm::dvec3 middleMm(19.5);

/// A disc, thick across the x axis.
test::ShapedMask disc()
{
    test::ShapedMask made({40, 40, 40});
    made.fill([](const glm::dvec3& at) {
        const glm::dvec3 off = at - middleMm;
        return std::abs(off.x) < 3.0 && std::hypot(off.y, off.z) < 10.0;
    });
    return made;
}

} // namespace

/// A surface whose yellow parts are pulled to another mask.
class FollowBoundaryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itIsKeptApartIfAsked();
};

void FollowBoundaryTest::itIsKeptApartIfAsked()
{
    const test::ShapedMask made = disc();
    const core::BoundaryForce boundary(made.mask(), made.geometry, 8.0);
    const glm::dvec3 middleLps = made.lps(middleMm);
    const glm::dvec3 across(7.0, 0.0, 0.0);
    // Two balls that look at each other within it: each is drawn to the far side of the disc.
    const core::SimplexMesh before =
        test::simplexMesh(test::together(test::moved(test::icosphere(6.0, 2), middleLps - across),
            test::moved(test::icosphere(6.0, 2), middleLps + across)));
    std::size_t crossings = 0;
    for (const bool isApart : {false, true}) {
        core::SimplexMesh mesh = before;
        core::SimplexMeshEdit edit(mesh);
        QVERIFY(core::followBoundary(
            edit, boundary, core::Progress(), isApart ? &made.geometry : nullptr));
        QVERIFY(!edit.commit().empty());
        QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>({2, 2}));
        const std::size_t left = core::selfIntersections(mesh, made.geometry).size();
        if (isApart)
            QCOMPARE(left, std::size_t(0));
        else
            crossings = left;
    }
    qInfo("%zu pairs cross without the guard", crossings);
    QVERIFY(crossings > 0);
}

BURIN_TEST(FollowBoundaryTest)

} // namespace followBoundaryTest

#include "FollowBoundaryTest.moc"
