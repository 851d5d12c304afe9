// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/MemoryFormula.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>

namespace memoryFormulaTest {

using gpu::MemoryFormula;

/// What is said of the memory of a volume agrees with itself, whatever its size.
class MemoryFormulaTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sizes_data()
    {
        QTest::addColumn<int>("x");
        QTest::addColumn<int>("y");
        QTest::addColumn<int>("z");
        QTest::newRow("one voxel") << 1 << 1 << 1;
        QTest::newRow("no multiple of a cell") << 17 << 9 << 1001;
        QTest::newRow("512³") << 512 << 512 << 512;
        QTest::newRow("beyond 32 bits") << 2048 << 2048 << 2048;
    }
    void sizes()
    {
        QFETCH(int, x);
        QFETCH(int, y);
        QFETCH(int, z);
        const glm::ivec3 size(x, y, z);
        const std::size_t voxels = std::size_t(x) * std::size_t(y) * std::size_t(z);
        const auto parts = MemoryFormula::denseParts(size);
        std::size_t sum = 0;
        for (const MemoryFormula::Part& part : parts) {
            QVERIFY2(part.bytes > 0, qPrintable(part.name));
            sum += part.bytes;
        }
        QCOMPARE(MemoryFormula::denseBytes(size), sum);
        const auto bytesOf = [&parts](const QString& name) {
            const auto found = std::find_if(parts.begin(), parts.end(),
                [&name](const MemoryFormula::Part& part) { return part.name == name; });
            return found == parts.end() ? 0 : found->bytes;
        };
        QCOMPARE(bytesOf(QStringLiteral("intensity")), 2 * voxels);
        QCOMPARE(bytesOf(QStringLiteral("labels")), voxels);
        QCOMPARE(bytesOf(QStringLiteral("radiation")), voxels);
        QCOMPARE(bytesOf(QStringLiteral("segmentation map")), voxels);
    }

    /// The manual says 5.1 bytes a voxel.
    void cellsTakeLittle()
    {
        const double voxels = 1024.0 * 1024.0 * 1024.0;
        const double each = double(MemoryFormula::denseBytes(glm::ivec3(1024))) / voxels;
        QVERIFY2(each > 5.0 && each < 5.15, QByteArray::number(each).constData());
    }

    /// Each dense texture that takes bytes for each voxel is a term of the formula.
    void theFormulaNamesThem()
    {
        const QString text = MemoryFormula::text();
        for (const MemoryFormula::Part& part : MemoryFormula::denseParts(glm::ivec3(64))) {
            if (!part.name.endsWith(QStringLiteral("cells")))
                QVERIFY2(text.contains(part.name), qPrintable(part.name));
        }
    }
};

BURIN_PLAIN_TEST(MemoryFormulaTest)

} // namespace memoryFormulaTest

#include "MemoryFormulaTest.moc"
