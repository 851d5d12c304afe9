// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/PickRays.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <cmath>

namespace pickRaysTest {

using core::OrthographicView;
using core::VolumeGeometry;

namespace {

VolumeGeometry tiltedGeometry()
{
    VolumeGeometry geometry;
    geometry.size = {40, 30, 20};
    geometry.indexToWorld =
        glm::dmat4(glm::dvec4(0.5, 0.0, 0.0, 0.0), glm::dvec4(0.0, 0.7, 0.0, 0.0),
            glm::dvec4(0.0, 0.3, 1.5, 0.0), glm::dvec4(-10.0, -12.0, 30.0, 1.0));
    return geometry;
}

} // namespace

class PickRaysTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void raysRunThroughTheirPointsInViewDirection()
    {
        const VolumeGeometry geometry = tiltedGeometry();
        OrthographicView view;
        view.targetLps = geometry.toWorld({20, 15, 10});
        view.eyeLps = view.targetLps + glm::dvec3(-30.0, -200.0, 40.0);
        view.up = {0.1, 0.2, 1.0};
        const std::vector<glm::dvec2> points{{0.0, 0.0}, {2.5, -1.25}, {-4.0, 3.0}};
        const core::PickRays picked = core::pickRays(view, points, geometry);
        QCOMPARE(picked.rays.size(), points.size());
        QCOMPARE(picked.sampleMm, 0.25);

        const glm::dvec3 forward = glm::normalize(view.targetLps - view.eyeLps);
        const glm::dvec3 right = glm::normalize(glm::cross(forward, view.up));
        const glm::dvec3 up = glm::cross(right, forward);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto& ray = picked.rays[i];
            QVERIFY(ray.samples > 10);
            for (const int sample : {0, ray.samples / 2, ray.samples - 1}) {
                const glm::dvec3 index =
                    (glm::dvec3(ray.origin) + double(sample) * glm::dvec3(ray.step)) / 65536.0;
                for (int axis = 0; axis < 3; ++axis) {
                    QVERIFY(index[axis] > -0.51); // to the border, not to the last centre
                    QVERIFY(index[axis] < geometry.size[axis] - 0.49);
                }
                const glm::dvec3 offset = geometry.toWorld(index) - view.targetLps;
                QVERIFY(std::abs(glm::dot(offset, right) - points[i].x) < 0.01);
                QVERIFY(std::abs(glm::dot(offset, up) - points[i].y) < 0.01);
            }
            // One sample further at either end would be outside.
            for (const int sample : {-1, ray.samples}) {
                const glm::dvec3 index =
                    (glm::dvec3(ray.origin) + double(sample) * glm::dvec3(ray.step)) / 65536.0;
                bool inside = true;
                for (int axis = 0; axis < 3; ++axis)
                    inside =
                        inside && index[axis] >= -0.5 && index[axis] <= geometry.size[axis] - 0.5;
                QVERIFY(!inside);
            }
        }
    }

    /// Picks land on what is seen: the same samples, but for those that a clip region hides.
    void raysEndWhereTheClipRegionDoes()
    {
        const VolumeGeometry geometry = tiltedGeometry();
        OrthographicView view;
        view.targetLps = geometry.toWorld({20, 15, 10});
        view.eyeLps = view.targetLps + glm::dvec3(-30.0, -200.0, 40.0);
        core::ClipRegion clip = core::wholeVolume(geometry);
        clip.box = {{5.0, 4.0, 3.0}, {30.0, 25.0, 15.0}, true};
        clip.planes[1] = {view.targetLps, glm::normalize(glm::dvec3(0.2, -1.0, 0.1)), true};
        const std::vector<core::HalfSpace> halves = core::halfSpaces(clip, geometry);
        std::vector<glm::dvec2> points;
        for (int i = 0; i < 60; ++i)
            points.push_back({-9.0 + 0.3 * i, 6.0 - 0.21 * i});
        const core::PickRays whole = core::pickRays(view, points, geometry);
        const core::PickRays clipped = core::pickRays(view, points, geometry, clip);
        int shorter = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::vector<glm::ivec3> expected;
            for (int n = 0; n < whole.rays[i].samples; ++n) {
                const glm::ivec3 at = whole.rays[i].origin + n * whole.rays[i].step;
                bool seen = true;
                for (const core::HalfSpace& half : halves)
                    seen = seen && glm::dot(half.normal, glm::dvec3(at) / 65536.0) <= half.offset;
                if (seen)
                    expected.push_back(at);
            }
            QVERIFY(std::abs(clipped.rays[i].samples - int(expected.size())) <= 1); // rounding
            if (expected.empty())
                continue;
            shorter += clipped.rays[i].samples < whole.rays[i].samples ? 1 : 0;
            const glm::ivec3 apart = clipped.rays[i].origin - expected.front();
            const glm::ivec3 step = glm::abs(clipped.rays[i].step);
            QVERIFY(glm::all(glm::lessThanEqual(glm::abs(apart), step + 64)));
        }
        QVERIFY(shorter > 20);
        // What hides everything leaves no samples.
        clip.planes[2] = {view.targetLps + glm::dvec3(0.0, 0.0, 500.0), {0.0, 0.0, -1.0}, true};
        for (const auto& ray : core::pickRays(view, points, geometry, clip).rays)
            QCOMPARE(ray.samples, 0);
    }

    void aRayThatMissesHasNoSamples()
    {
        const VolumeGeometry geometry = tiltedGeometry();
        OrthographicView view;
        view.targetLps = geometry.toWorld({20, 15, 10});
        view.eyeLps = view.targetLps - glm::dvec3(0.0, 100.0, 0.0);
        const auto picked = core::pickRays(view, {{500.0, 0.0}, {0.0, 0.0}}, geometry);
        QCOMPARE(picked.rays[0].samples, 0);
        QVERIFY(picked.rays[1].samples > 0);
    }
};

BURIN_TEST(PickRaysTest)

} // namespace pickRaysTest

#include "PickRaysTest.moc"
