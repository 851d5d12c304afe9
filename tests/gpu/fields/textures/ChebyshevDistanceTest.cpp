// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/textures/ChebyshevDistance.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <random>

namespace chebyshevDistanceTest {

class ChebyshevDistanceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void equalsTheDefinition_data()
    {
        QTest::addColumn<int>("oneIn");
        QTest::newRow("dense") << 3;
        QTest::newRow("sparse") << 60;
        QTest::newRow("nearly empty") << 400;
    }

    void equalsTheDefinition()
    {
        QFETCH(int, oneIn);
        const glm::ivec3 cells(9, 7, 11);
        std::mt19937 random(1);
        std::vector<std::uint8_t> occupied(std::size_t(cells.x * cells.y * cells.z));
        std::vector<glm::ivec3> places;
        for (int z = 0; z < cells.z; ++z)
            for (int y = 0; y < cells.y; ++y)
                for (int x = 0; x < cells.x; ++x)
                    if (random() % unsigned(oneIn) == 0) {
                        occupied[std::size_t((z * cells.y + y) * cells.x + x)] = 1;
                        places.push_back({x, y, z});
                    }
        QVERIFY(!places.empty());
        const auto distance = gpu::chebyshevDistance(cells, occupied);
        for (int z = 0; z < cells.z; ++z)
            for (int y = 0; y < cells.y; ++y)
                for (int x = 0; x < cells.x; ++x) {
                    int least = 255;
                    for (const glm::ivec3& place : places) {
                        const glm::ivec3 apart = glm::abs(place - glm::ivec3(x, y, z));
                        least = std::min(least, std::max({apart.x, apart.y, apart.z}));
                    }
                    QCOMPARE(int(distance[std::size_t((z * cells.y + y) * cells.x + x)]), least);
                }
    }

    void farIsCapped()
    {
        std::vector<std::uint8_t> occupied(300, 0);
        QCOMPARE(int(gpu::chebyshevDistance({300, 1, 1}, occupied)[7]), 255);
        occupied[0] = 1;
        const auto distance = gpu::chebyshevDistance({300, 1, 1}, occupied);
        QCOMPARE(int(distance[200]), 200);
        QCOMPARE(int(distance[299]), 255);
    }
};

BURIN_TEST(ChebyshevDistanceTest)

} // namespace chebyshevDistanceTest

#include "ChebyshevDistanceTest.moc"
