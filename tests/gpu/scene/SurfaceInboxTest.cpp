// SPDX-License-Identifier: Apache-2.0
#include "gpu/scene/SurfaceInbox.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <map>
#include <thread>

namespace surfaceInboxTest {

using namespace gpu;

namespace {

/// What somebody knows who took in updates one by one.
struct Known {
    std::map<core::VertexId, glm::dvec3> vertices;
    std::map<core::FaceId, core::FaceRing> faces;

    void take(const core::SurfaceUpdate& update)
    {
        if (update.isWhole)
            *this = {};
        for (const auto& vertex : update.vertices)
            vertices[vertex.id] = vertex.positionLps;
        for (const auto& face : update.faces) {
            faces.erase(face.id);
            if (!face.ring.empty())
                faces[face.id] = face.ring;
        }
    }
    bool operator==(const Known&) const = default;
};

core::SurfaceUpdate randomUpdate(test::Random& random, bool isWhole)
{
    core::SurfaceUpdate update{.isWhole = isWhole};
    for (core::VertexId id = 0; id < 30; ++id) {
        if (isWhole || test::randomInt(random, 0, 3) == 0)
            update.vertices.push_back({.id = id, .positionLps = {test::randomUnit(random), 0, 0}});
    }
    for (core::FaceId id = 0; id < 15; ++id) {
        if (!isWhole && test::randomInt(random, 0, 3) != 0)
            continue;
        const auto first = core::VertexId(test::randomInt(random, 0, 20));
        const bool gone = test::randomInt(random, 0, 4) == 0;
        update.faces.push_back({.id = id,
            .ring = gone ? core::FaceRing{} : core::FaceRing{first, first + 1, first + 2}});
    }
    return update;
}

} // namespace

class SurfaceInboxTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void mergedIsAsOneByOne()
    {
        test::Random random(11);
        for (int round = 0; round < 200; ++round) {
            SurfaceInbox inbox;
            QVERIFY(!inbox.take());
            Known oneByOne;
            Known merged;
            for (int i = 0; i < 12; ++i) {
                const core::SurfaceUpdate update =
                    randomUpdate(random, i == 0 || test::randomInt(random, 0, 5) == 0);
                oneByOne.take(update);
                inbox.put(update);
                if (test::randomInt(random, 0, 3) != 0)
                    continue;
                const auto taken = inbox.take();
                QVERIFY(taken);
                merged.take(*taken);
                QVERIFY(!inbox.take());
            }
            if (const auto taken = inbox.take())
                merged.take(*taken);
            QVERIFY(merged == oneByOne);
        }
    }

    void fromAnotherThread()
    {
        SurfaceInbox inbox;
        inbox.put({.isWhole = true});
        std::thread other([&] {
            for (core::VertexId id = 0; id < 5000; ++id)
                inbox.put({.vertices = {{.id = id, .positionLps = {double(id), 0, 0}}}});
        });
        Known known;
        while (known.vertices.size() < 5000) {
            if (const auto taken = inbox.take())
                known.take(*taken);
        }
        other.join();
        for (const auto& [id, place] : known.vertices)
            QCOMPARE(place.x, double(id));
    }
};

BURIN_TEST(SurfaceInboxTest)

} // namespace surfaceInboxTest

#include "SurfaceInboxTest.moc"
