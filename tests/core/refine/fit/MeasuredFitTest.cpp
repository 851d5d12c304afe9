// SPDX-License-Identifier: Apache-2.0
#include "core/refine/fit/MeasuredFit.h"
#include "core/brick/VoxelRunSets.h"
#include "core/refine/deform/RefineSurface.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <cmath>
#include <utility>
#include <vector>

namespace measuredFitTest {

namespace {

core::MeasuredFit fitted(const test::ShapedMask& mask, std::optional<int> vertices)
{
    auto fit = core::measuredFit(mask.voxels(), mask.geometry, vertices, {});
    if (!fit)
        qFatal("%s", qPrintable(fit.error().arguments.value(0)));
    return *std::move(fit);
}

std::uint64_t off(const core::SimplexMesh& mesh, const test::ShapedMask& mask)
{
    return core::differing(*core::voxelsOf(mesh, mask.geometry, {}), mask.voxels()).voxelCount();
}

test::ShapedMask shaped(const QString& shape)
{
    const bool isLayered = shape == QLatin1String("layered");
    test::ShapedMask made({40, 40, isLayered ? 14 : 40}, {1, 1, isLayered ? 3.0 : 1.0});
    test::Random random(3);
    const glm::dvec3 middle(19.4, 19.7, 20.2);
    made.fill([&](const glm::dvec3& at) {
        const double far = glm::distance(at, middle);
        const glm::ivec3 voxel(at);
        if (shape == QLatin1String("rough"))
            return far < 11.0 + double(test::randomInt(random, 0, 2));
        if (shape == QLatin1String("thin"))
            return (far < 9.0 && (voxel.x + voxel.y) % 4 != 0) || voxel.z == 35
                || (voxel.x % 6 == 1 && voxel.y == 3);
        if (shape == QLatin1String("sparse"))
            return test::randomInt(random, 0, 99) == 0;
        if (shape == QLatin1String("winding"))
            return std::hypot(at.x - 20.0 - 12.0 * std::sin(at.z / 7.0), at.y - 20.0) < 2.6;
        return far < 15.0;
    });
    return made;
}

} // namespace

/// How well a surface encloses the mask that it is laid around.
class MeasuredFitTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void asManyAsItTakes_data();
    void asManyAsItTakes();
    void asManyAsAskedFor();
    void keptApartItCrossesNowhere();
    void noMoreThanTheRulesAllow();
    void nothing();
};

void MeasuredFitTest::asManyAsItTakes_data()
{
    QTest::addColumn<QString>("shape");
    for (const char* shape : {"round", "layered", "rough", "thin", "sparse", "winding"})
        QTest::newRow(shape) << QString::fromLatin1(shape);
}

void MeasuredFitTest::asManyAsItTakes()
{
    QFETCH(QString, shape);
    const test::ShapedMask mask = shaped(shape);
    const core::MeasuredFit fit = fitted(mask, std::nullopt);
    qInfo("%zu vertices, %llu of %llu voxels off", fit.mesh.vertexCount(),
        static_cast<unsigned long long>(fit.voxelsOff),
        static_cast<unsigned long long>(fit.voxels));
    QVERIFY(core::checkSimplexMesh(fit.mesh));
    QCOMPARE(fit.voxels, mask.voxels().voxelCount());
    QCOMPARE(fit.voxelsOff, off(fit.mesh, mask));
    QVERIFY(double(fit.voxelsOff) <= core::mostOffShare * double(fit.voxels));
    QVERIFY(fit.mesh.vertexCount() <= std::size_t(core::mostVerticesOnce));
    if (shape == QLatin1String("rough"))
        QVERIFY(core::identical(fit.mesh, fitted(mask, std::nullopt).mesh));
}

void MeasuredFitTest::asManyAsAskedFor()
{
    const test::ShapedMask mask = shaped(QStringLiteral("round"));
    const core::MeasuredFit coarse = fitted(mask, 400);
    QVERIFY(coarse.mesh.vertexCount() < 1000);
    QCOMPARE(coarse.voxelsOff, off(coarse.mesh, mask));
    QVERIFY(double(coarse.voxelsOff) > core::mostOffShare * double(coarse.voxels));
}

/// Noise that is not even nearly followed by so few vertices crumples.
void MeasuredFitTest::keptApartItCrossesNowhere()
{
    test::Random random(7);
    for (const int share : {30, 50, 70}) {
        test::ShapedMask mask({9, 8, 7}, {1.0, 1.0, 2.0});
        for (auto& label : mask.labels)
            label = test::randomInt(random, 0, 99) < share ? 1 : 0;
        for (const int vertices : {100, 600}) {
            const auto fit =
                core::measuredFit(mask.voxels(), mask.geometry, vertices, {}, {.keepsApart = true});
            QVERIFY(fit.has_value());
            QVERIFY(core::checkSimplexMesh(fit->mesh));
            QCOMPARE(fit->crossings, std::size_t(0));
            QVERIFY(core::selfIntersections(fit->mesh, mask.geometry).empty());
            QCOMPARE(fit->voxelsOff, off(fit->mesh, mask));
            const auto before = core::measuredFit(mask.voxels(), mask.geometry, vertices, {});
            qInfo("%d %% of noise: %zu vertices, %llu of %llu voxels off; %zu pairs cross if it is "
                  "not kept apart",
                share, fit->mesh.vertexCount(), static_cast<unsigned long long>(fit->voxelsOff),
                static_cast<unsigned long long>(fit->voxels),
                core::selfIntersections(before->mesh, mask.geometry).size());
        }
    }
}

/// Plates with 25 000 faces, which is more than either rule allows.
void MeasuredFitTest::noMoreThanTheRulesAllow()
{
    test::ShapedMask plates({40, 40, 40});
    plates.fill([](const glm::dvec3& at) {
        const glm::ivec3 voxel(at);
        return voxel.x > 1 && voxel.x < 38 && voxel.y > 1 && voxel.y < 38 && voxel.z % 5 < 2;
    });
    std::vector<core::MeasuredFit> fits;
    for (const int most : {10'000, 20'000}) {
        auto fit = core::measuredFit(
            plates.voxels(), plates.geometry, std::nullopt, {}, {.mostVertices = most});
        QVERIFY(fit.has_value());
        QCOMPARE(fit->voxelsOff, off(fit->mesh, plates));
        qInfo("%zu vertices where %d are allowed", fit->mesh.vertexCount(), most);
        fits.push_back(*std::move(fit));
    }
    QVERIFY(fits[0].mesh.vertexCount() < fits[1].mesh.vertexCount());
}

void MeasuredFitTest::nothing()
{
    test::ShapedMask mask({5, 5, 5});
    QCOMPARE(fitted(mask, std::nullopt).mesh.vertexCount(), std::size_t(0));
    mask.at(2, 2, 2) = 1;
    QCOMPARE(fitted(mask, std::nullopt).voxelsOff, std::uint64_t(0));
    core::Progress progress;
    progress.cancel();
    const auto cancelled = core::measuredFit(mask.voxels(), mask.geometry, {}, progress);
    QVERIFY(!cancelled && cancelled.error().code == core::ErrorCode::Cancelled);
}

BURIN_TEST(MeasuredFitTest)

} // namespace measuredFitTest

#include "MeasuredFitTest.moc"
