// SPDX-License-Identifier: Apache-2.0
#include "core/nrrd/NrrdWriter.h"
#include "core/nrrd/NrrdHeader.h"
#include "core/nrrd/NrrdReader.h"
#include "tests/support/program/TestProgram.h"

#include <glm/gtc/matrix_transform.hpp>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cstring>

namespace nrrdWriterTest {

namespace {

core::VolumeGeometry obliqueGrid()
{
    core::VolumeGeometry geometry;
    geometry.size = {5, 4, 3};
    geometry.indexToWorld = glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, -1)));
    geometry.indexToWorld[0] *= 0.1;
    geometry.indexToWorld[1] *= 1.0 / 3.0;
    geometry.indexToWorld[2] *= 2.5;
    geometry.indexToWorld[3] = {-119.53100000000005, 1e-7, 1234.1, 1.0};
    return geometry;
}

std::vector<std::uint8_t> voxelsOf(const core::VolumeGeometry& geometry)
{
    std::vector<std::uint8_t> voxels(geometry.voxelCount());
    for (std::size_t i = 0; i < voxels.size(); ++i)
        voxels[i] = std::uint8_t(i * 5);
    return voxels;
}

} // namespace

class NrrdWriterTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theHeaderIsAsTheFormatHasIt();
    void theReaderSeesTheSameToTheLastBit();
    void severalNumbersOfAVoxel();
    void keyValuesAreEscaped();
    void refusesTooFewVoxels();
    void aFullDiskIsNamed();

private:
    [[nodiscard]] QString path() const { return m_folder.filePath(QStringLiteral("a.nrrd")); }
    QTemporaryDir m_folder;
};

void NrrdWriterTest::theHeaderIsAsTheFormatHasIt()
{
    core::VolumeGeometry geometry;
    geometry.size = {2, 1, 1};
    geometry.indexToWorld = glm::dmat4(glm::dvec4(-0.5, 0, 0, 0), glm::dvec4(0, 0.25, 0, 0),
        glm::dvec4(0, -0.0, 3, 0), glm::dvec4(-1, 2, 30.125, 1));
    const std::vector<std::uint8_t> voxels{7, 9};
    const auto written = core::writeNrrdAt(
        path(), {.geometry = geometry, .voxels = voxels, .keyValues = {{"a key", "its value"}}});
    QVERIFY(written);
    QFile file(path());
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    const QByteArray header("NRRD0004\n"
                            "# Complete NRRD file format specification at:\n"
                            "# http://teem.sourceforge.net/nrrd/format.html\n"
                            "type: unsigned char\n"
                            "dimension: 3\n"
                            "space: left-posterior-superior\n"
                            "sizes: 2 1 1\n"
                            "space directions: (-0.5,0,0) (0,0.25,0) (0,0,3)\n"
                            "kinds: domain domain domain\n"
                            "encoding: gzip\n"
                            "space origin: (-1,2,30.125)\n"
                            "a key:=its value\n"
                            "\n");
    QCOMPARE(bytes.left(header.size()), header);
    // What follows at once is gzip.
    QCOMPARE(bytes.mid(header.size(), 3), QByteArray("\x1f\x8b\x08"));
}

void NrrdWriterTest::theReaderSeesTheSameToTheLastBit()
{
    const core::VolumeGeometry geometry = obliqueGrid();
    const std::vector<std::uint8_t> voxels = voxelsOf(geometry);
    QVERIFY(core::writeNrrdAt(path(), {.geometry = geometry, .voxels = voxels, .keyValues = {}}));
    const auto grid = core::readNrrd(path());
    QVERIFY(grid);
    QVERIFY(grid->problems.empty());
    QVERIFY(grid->geometry.size == geometry.size);
    QVERIFY(grid->geometry.indexToWorld == geometry.indexToWorld);
    QVERIFY(grid->voxels.type == core::ScalarType::UInt8);
    const auto bytes = core::readVoxels(grid->voxels, {});
    QVERIFY(bytes);
    QVERIFY(!bytes->surplus);
    QCOMPARE(bytes->size, voxels.size());
    QCOMPARE(std::memcmp(bytes->data.get(), voxels.data(), voxels.size()), 0);
}

void NrrdWriterTest::severalNumbersOfAVoxel()
{
    core::VolumeGeometry geometry = obliqueGrid();
    std::vector<std::uint8_t> voxels;
    for (std::size_t i = 0; i < 3 * geometry.voxelCount(); ++i)
        voxels.push_back(std::uint8_t(i * 7 % 251));
    QVERIFY(core::writeNrrdAt(
        path(), {.geometry = geometry, .voxels = voxels, .keyValues = {}, .layers = 3}));
    const auto read = core::readNrrdLayers(path());
    QVERIFY(read);
    QCOMPARE(read->layers, 3);
    QVERIFY(read->grid.geometry.size == geometry.size);
    QVERIFY(read->grid.geometry.indexToWorld == geometry.indexToWorld);
    const auto bytes = core::readVoxels(read->grid.voxels, {});
    QVERIFY(bytes);
    QVERIFY(!bytes->surplus);
    QCOMPARE(bytes->size, voxels.size());
    QCOMPARE(std::memcmp(bytes->data.get(), voxels.data(), voxels.size()), 0);
    QFile file(path());
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray header = file.read(1000);
    for (const char* line : {"\ndimension: 4\n", "\nsizes: 3 ", "\nspace directions: none (",
             "\nkinds: list domain domain domain\n"})
        QVERIFY2(header.contains(line), line);
}

void NrrdWriterTest::keyValuesAreEscaped()
{
    const core::VolumeGeometry geometry = obliqueGrid();
    const std::vector<std::uint8_t> voxels = voxelsOf(geometry);
    const std::vector<std::pair<QByteArray, QByteArray>> keyValues{{"plain", "a word"},
        {"empty", ""}, {"lines", "one\ntwo\n\nfour"}, {"marks", "C:\\new\\n := # \"x\" "},
        {"letters",
            "Sch\xc3\xa4"
            "del \xe9\xa0\xad\xe8\x93\x8b \xf0\x9f\xa6\xb4"}};
    QVERIFY(core::writeNrrdAt(
        path(), {.geometry = geometry, .voxels = voxels, .keyValues = keyValues}));
    const auto header = core::readNrrdHeader(path());
    QVERIFY(header);
    QVERIFY(header->bytes.contains("\nlines:=one\\ntwo\\n\\nfour\n"));
    QVERIFY(header->bytes.contains("\nmarks:=C:\\\\new\\\\n := # \"x\" \n"));
    QCOMPARE(header->keyValues.size(), keyValues.size());
    for (const auto& [key, value] : keyValues)
        QCOMPARE(header->keyValues.at(key), value);
}

void NrrdWriterTest::refusesTooFewVoxels()
{
    const std::vector<std::uint8_t> voxels(3);
    const auto refused =
        core::writeNrrdAt(path(), {.geometry = obliqueGrid(), .voxels = voxels, .keyValues = {}});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::UnsupportedFormat);
}

void NrrdWriterTest::aFullDiskIsNamed()
{
    const core::VolumeGeometry geometry = obliqueGrid();
    const std::vector<std::uint8_t> voxels = voxelsOf(geometry);
    const auto refused = core::writeNrrdAt(
        QStringLiteral("/dev/full"), {.geometry = geometry, .voxels = voxels, .keyValues = {}});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::FileUnwritable);
    QVERIFY(!refused.error().arguments.value(1).isEmpty());
}

BURIN_TEST(NrrdWriterTest)

} // namespace nrrdWriterTest

#include "NrrdWriterTest.moc"
