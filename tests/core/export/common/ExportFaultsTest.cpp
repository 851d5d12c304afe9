// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckExport.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/AlterDicom.h"
#include "tests/support/series/SmallSeries.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <array>
#include <cstring>
#include <functional>
#include <random>
#include <utility>

namespace exportFaultsTest {

/// Faults put into a written file, or into the source behind the program's back: each must be named
/// by the check. Everything here is asymmetric, so that no fault can hide.
class ExportFaultsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void faultInTheSegIsCaught_data();
    void faultInTheSegIsCaught();
    void faultInTheSourceIsCaught_data();
    void faultInTheSourceIsCaught();
    void faultInTheNiftiIsCaught_data();
    void faultInTheNiftiIsCaught();
    void faultOfTheVolumeIsCaught_data();
    void faultOfTheVolumeIsCaught();

private:
    /// A fresh copy of the series, since tests alter it.
    core::Volume freshSeries(const QString& folder);
    core::ExportRequest requestFor(core::ExportFormat format, const QString& file);
    core::ExportExpectation expectationOf(const core::Volume& volume);

    test::SmallSeries m_series;
    std::vector<std::uint8_t> m_labels;
    std::vector<core::LabelPlaneView> m_planes;
    std::vector<core::Segment> m_segments;
};

namespace {

using Alter = std::function<void(DcmDataset&)>;

/// The item with a macro's attribute for a frame of a SEG.
DcmItem& macro(DcmDataset& dataset, const DcmTagKey& sequence, long frame)
{
    DcmItem* group = nullptr;
    DcmItem* item = nullptr;
    if (dataset.findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, group, frame).good()
        && group->findAndGetSequenceItem(sequence, item).good())
        return *item;
    dataset.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, group);
    group->findAndGetSequenceItem(sequence, item);
    return *item;
}

long frameCount(DcmDataset& dataset)
{
    DcmSequenceOfItems* frames = nullptr;
    dataset.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, frames);
    return long(frames->card());
}

std::vector<double> numbers(DcmItem& item, const DcmTagKey& tag)
{
    std::vector<double> values;
    Float64 value = 0.0;
    for (unsigned long i = 0; item.findAndGetFloat64(tag, value, i).good(); ++i)
        values.push_back(value);
    return values;
}

void putNumbers(DcmItem& item, const DcmTagKey& tag, const std::vector<double>& values)
{
    QStringList texts;
    for (const double value : values)
        texts += QString::number(value, 'g', 10);
    item.putAndInsertString(tag, texts.join(QLatin1Char('\\')).toLatin1().constData());
}

void moveBy(DcmItem& item, const glm::dvec3& by)
{
    auto position = numbers(item, DCM_ImagePositionPatient);
    for (int axis = 0; axis < 3; ++axis)
        position[std::size_t(axis)] += by[axis];
    putNumbers(item, DCM_ImagePositionPatient, position);
}

/// Negates the row's (0) or the column's (3) direction.
void turn(DcmItem& item, std::size_t first)
{
    auto orientation = numbers(item, DCM_ImageOrientationPatient);
    for (std::size_t i = first; i < first + 3; ++i)
        orientation[i] = -orientation[i];
    putNumbers(item, DCM_ImageOrientationPatient, orientation);
}

void swapSpacing(DcmItem& item)
{
    auto spacing = numbers(item, DCM_PixelSpacing);
    std::swap(spacing[0], spacing[1]);
    putNumbers(item, DCM_PixelSpacing, spacing);
}

/// Rearranges the pixels of every frame: `from(column, row, frame)` is where a pixel comes from.
void rearrange(
    DcmDataset& dataset, const glm::ivec3& size, const std::function<glm::ivec3(glm::ivec3)>& from)
{
    const Uint8* bytes = nullptr;
    unsigned long count = 0;
    QVERIFY(dataset.findAndGetUint8Array(DCM_PixelData, bytes, &count).good());
    std::vector<Uint8> changed(count, 0);
    const auto bitOf = [&](const glm::ivec3& pixel) {
        return std::size_t((pixel.z * size.y + pixel.y) * size.x + pixel.x);
    };
    for (int frame = 0; frame < size.z; ++frame) {
        for (int row = 0; row < size.y; ++row) {
            for (int column = 0; column < size.x; ++column) {
                const std::size_t source = bitOf(from({column, row, frame}));
                const std::size_t target = bitOf({column, row, frame});
                if (((bytes[source / 8] >> (source % 8)) & 1) != 0)
                    changed[target / 8] |= Uint8(1U << (target % 8));
            }
        }
    }
    QVERIFY(dataset.putAndInsertUint8Array(DCM_PixelData, changed.data(), count).good());
}

/// Alters the header of an uncompressed NIfTI file in place.
void alterNifti(const QString& file, const std::function<void(QByteArray&)>& change)
{
    QFile opened(file);
    QVERIFY(opened.open(QIODevice::ReadWrite));
    QByteArray bytes = opened.readAll();
    change(bytes);
    QVERIFY(opened.seek(0) && opened.write(bytes) == bytes.size());
}

const std::array<std::pair<core::ExportFormat, const char*>, 3> formats{
    std::pair(core::ExportFormat::DicomSeg, "seg.dcm"),
    std::pair(core::ExportFormat::Nifti, "seg.nii.gz"),
    std::pair(core::ExportFormat::SegNrrd, "mask.seg.nrrd")};

float floatAt(const QByteArray& bytes, int offset)
{
    float value = 0.0F;
    std::memcpy(&value, bytes.constData() + offset, sizeof value);
    return value;
}

void putFloat(QByteArray& bytes, int offset, float value)
{
    std::memcpy(bytes.data() + offset, &value, sizeof value);
}

constexpr int srow = 280;
constexpr int qoffset = 268;
constexpr int quaternion = 256;
constexpr int pixdim = 76;
constexpr int voxelStart = 352;

} // namespace

} // namespace exportFaultsTest

Q_DECLARE_METATYPE(exportFaultsTest::Alter)
Q_DECLARE_METATYPE(std::function<void(QByteArray&)>)
Q_DECLARE_METATYPE(std::function<void(core::Volume&)>)

namespace exportFaultsTest {

void ExportFaultsTest::initTestCase()
{
    m_series.size = {11, 7, 6};
    m_series.spacing = {0.7, 0.9};
    m_series.placeEvenly({-40.25, -31.5, 812.125}, {0, 0, 2.5});
    std::mt19937 random(5);
    m_labels.resize(std::size_t(m_series.size.x * m_series.size.y * m_series.size.z));
    for (auto& label : m_labels)
        label = std::uint8_t(random() % 3);
    m_planes = {{.plane = 0, .labels = m_labels}};
    for (const int label : {1, 2}) {
        core::Segment segment;
        segment.label = std::uint8_t(label);
        segment.name = QStringLiteral("Skull");
        segment.code = {.scheme = QStringLiteral("SCT"),
            .value = QStringLiteral("89546000"),
            .meaning = QStringLiteral("Skull")};
        m_segments.push_back(segment);
    }
}

core::Volume ExportFaultsTest::freshSeries(const QString& folder)
{
    return m_series.write(folder);
}

core::ExportRequest ExportFaultsTest::requestFor(core::ExportFormat format, const QString& file)
{
    return {.format = format, .file = file, .segments = m_segments, .planes = m_planes};
}

core::ExportExpectation ExportFaultsTest::expectationOf(const core::Volume& volume)
{
    return {volume, m_segments, m_planes};
}

void ExportFaultsTest::faultInTheSegIsCaught_data()
{
    QTest::addColumn<Alter>("change");
    const glm::ivec3 size = m_series.size;
    const glm::ivec3 frames(size.x, size.y, 2 * size.z);

    const auto everyFrame = [](auto change) {
        return Alter([change](DcmDataset& dataset) {
            for (long frame = 0; frame < frameCount(dataset); ++frame)
                change(dataset, frame);
        });
    };
    const auto once = [](const DcmTagKey& sequence, auto change) {
        return Alter([=](DcmDataset& dataset) { change(macro(dataset, sequence, 0)); });
    };
    QTest::newRow("flip of columns, in the orientation")
        << once(DCM_PlaneOrientationSequence, [](DcmItem& item) { turn(item, 0); });
    QTest::newRow("flip of rows, in the orientation")
        << once(DCM_PlaneOrientationSequence, [](DcmItem& item) { turn(item, 3); });
    QTest::newRow("flip of slices, in the positions")
        << everyFrame([=](DcmDataset& dataset, long i) {
               const double half = 0.5 * (size.z - 1) * 2.5;
               DcmItem& item = macro(dataset, DCM_PlanePositionSequence, i);
               const double z = numbers(item, DCM_ImagePositionPatient)[2];
               moveBy(item, {0, 0, 2.0 * (812.125 + half - z)});
           });
    QTest::newRow("flip of columns, in the pixels") << Alter([=](DcmDataset& dataset) {
        rearrange(
            dataset, frames, [=](glm::ivec3 p) { return glm::ivec3(size.x - 1 - p.x, p.y, p.z); });
    });
    QTest::newRow("flip of rows, in the pixels") << Alter([=](DcmDataset& dataset) {
        rearrange(
            dataset, frames, [=](glm::ivec3 p) { return glm::ivec3(p.x, size.y - 1 - p.y, p.z); });
    });
    QTest::newRow("flip of slices, in the pixels") << Alter([=](DcmDataset& dataset) {
        rearrange(dataset, frames, [=](glm::ivec3 p) {
            const int segment = p.z / size.z;
            return glm::ivec3(p.x, p.y, segment * size.z + size.z - 1 - p.z % size.z);
        });
    });
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 shift(0.0);
        shift[axis] = 0.5 * glm::dvec3(0.7, 0.9, 2.5)[axis];
        QTest::addRow("half a voxel along axis %d", axis)
            << everyFrame([shift](DcmDataset& dataset, long i) {
                   moveBy(macro(dataset, DCM_PlanePositionSequence, i), shift);
               });
    }
    QTest::newRow("one frame half a voxel off") << Alter([](DcmDataset& dataset) {
        moveBy(macro(dataset, DCM_PlanePositionSequence, 7), {0.35, 0, 0});
    });
    QTest::newRow("row and column spacing swapped")
        << once(DCM_PixelMeasuresSequence, [](DcmItem& item) { swapSpacing(item); });
    QTest::newRow("another patient's name") << Alter(
        [](DcmDataset& dataset) { dataset.putAndInsertString(DCM_PatientName, "Maier^Anna"); });
    QTest::newRow("another patient's ID")
        << Alter([](DcmDataset& dataset) { dataset.putAndInsertString(DCM_PatientID, "P-0816"); });
    QTest::newRow("another birth date") << Alter(
        [](DcmDataset& dataset) { dataset.putAndInsertString(DCM_PatientBirthDate, "19500201"); });
    QTest::newRow("another study") << Alter(
        [](DcmDataset& dataset) { dataset.putAndInsertString(DCM_StudyInstanceUID, "2.25.4711"); });
    QTest::newRow("another frame of reference") << Alter([](DcmDataset& dataset) {
        dataset.putAndInsertString(DCM_FrameOfReferenceUID, "2.25.4711");
    });
    QTest::newRow("reference to another slice") << Alter([](DcmDataset& dataset) {
        DcmItem* a = nullptr;
        DcmItem* b = nullptr;
        macro(dataset, DCM_DerivationImageSequence, 0)
            .findAndGetSequenceItem(DCM_SourceImageSequence, a);
        macro(dataset, DCM_DerivationImageSequence, 1)
            .findAndGetSequenceItem(DCM_SourceImageSequence, b);
        OFString uid;
        b->findAndGetOFString(DCM_ReferencedSOPInstanceUID, uid);
        a->putAndInsertString(DCM_ReferencedSOPInstanceUID, uid.c_str());
    });
    QTest::newRow("reference to no image of the study") << Alter([](DcmDataset& dataset) {
        DcmItem* item = nullptr;
        macro(dataset, DCM_DerivationImageSequence, 3)
            .findAndGetSequenceItem(DCM_SourceImageSequence, item);
        item->putAndInsertString(DCM_ReferencedSOPInstanceUID, "2.25.4711");
    });
    QTest::newRow("one voxel") << Alter([](DcmDataset& dataset) {
        const Uint8* bytes = nullptr;
        unsigned long count = 0;
        QVERIFY(dataset.findAndGetUint8Array(DCM_PixelData, bytes, &count).good());
        std::vector<Uint8> changed(bytes, bytes + count);
        changed[41] ^= 0x10;
        QVERIFY(dataset.putAndInsertUint8Array(DCM_PixelData, changed.data(), count).good());
    });
    QTest::newRow("segments exchanged") << everyFrame([=](DcmDataset& dataset, long i) {
        macro(dataset, DCM_SegmentIdentificationSequence, i)
            .putAndInsertUint16(DCM_ReferencedSegmentNumber, i < size.z ? 2 : 1);
    });
    QTest::newRow("a frame less") << Alter([](DcmDataset& dataset) {
        DcmSequenceOfItems* items = nullptr;
        dataset.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, items);
        delete items->remove(items->card() - 1);
        dataset.putAndInsertString(DCM_NumberOfFrames, std::to_string(items->card()).c_str());
    });
}

void ExportFaultsTest::faultInTheSegIsCaught()
{
    QFETCH(Alter, change);
    QTemporaryDir folder;
    const core::Volume volume = freshSeries(folder.filePath(QStringLiteral("images")));
    const QString file = folder.filePath(QStringLiteral("seg.dcm"));
    QVERIFY(core::exportMask(volume, requestFor(core::ExportFormat::DicomSeg, file), {}));
    // The way through DCMTK and back alone is no fault.
    test::alterDicom(file, [](DcmDataset&) {});
    QVERIFY(core::checkSegExport(file, expectationOf(volume), {}));
    test::alterDicom(file, change);
    const auto checked = core::checkSegExport(file, expectationOf(volume), {});
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, core::ErrorCode::ExportMismatch);
    QCOMPARE(checked.error().arguments.value(0), file);
    QVERIFY(!checked.error().arguments.value(1).isEmpty());
}

void ExportFaultsTest::faultInTheSourceIsCaught_data()
{
    QTest::addColumn<Alter>("change");
    QTest::addColumn<bool>("everywhere");

    QTest::newRow("flip of columns") << Alter([](DcmDataset& d) { turn(d, 0); }) << true;
    QTest::newRow("flip of rows") << Alter([](DcmDataset& d) { turn(d, 3); }) << true;
    QTest::newRow("flip of slices") << Alter([](DcmDataset& d) {
        const double z = numbers(d, DCM_ImagePositionPatient)[2];
        moveBy(d, {0, 0, 2.0 * (812.125 + 6.25 - z)});
    }) << true;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 shift(0.0);
        shift[axis] = 0.5 * glm::dvec3(0.7, 0.9, 2.5)[axis];
        QTest::addRow("half a voxel along axis %d", axis)
            << Alter([shift](DcmDataset& d) { moveBy(d, shift); }) << true;
    }
    QTest::newRow("one slice off") << Alter([](DcmDataset& d) {
        moveBy(d, {0, 0, 1.25});
    }) << false;
    QTest::newRow("row and column spacing swapped") << Alter(swapSpacing) << true;
    QTest::newRow("another patient") << Alter([](DcmDataset& d) {
        d.putAndInsertString(DCM_PatientName, "Maier^Anna");
        d.putAndInsertString(DCM_PatientID, "P-0816");
    }) << true;
    QTest::newRow("one slice of another patient")
        << Alter([](DcmDataset& d) { d.putAndInsertString(DCM_PatientID, "P-0816"); }) << false;
    QTest::newRow("one slice of a namesake")
        << Alter([](DcmDataset& d) { d.putAndInsertString(DCM_PatientBirthDate, "19510102"); })
        << false;
    QTest::newRow("another study")
        << Alter([](DcmDataset& d) { d.putAndInsertString(DCM_StudyInstanceUID, "2.25.4711"); })
        << true;
    QTest::newRow("another frame of reference")
        << Alter([](DcmDataset& d) { d.putAndInsertString(DCM_FrameOfReferenceUID, "2.25.4711"); })
        << false;
    QTest::newRow("another image in the file")
        << Alter([](DcmDataset& d) { d.putAndInsertString(DCM_SOPInstanceUID, "2.25.4711"); })
        << false;
}

void ExportFaultsTest::faultInTheSourceIsCaught()
{
    QFETCH(Alter, change);
    QFETCH(bool, everywhere);
    for (const auto& [format, name] : formats) {
        QTemporaryDir folder;
        const core::Volume volume = freshSeries(folder.filePath(QStringLiteral("images")));
        const QString file = folder.filePath(QLatin1String(name));
        QVERIFY(core::exportMask(volume, requestFor(format, file), {}));
        QVERIFY(QFile::remove(file));
        for (std::size_t k = 0; k < volume.sources.size(); ++k) {
            if (everywhere || k == 2)
                test::alterDicom(volume.sources[k].file, change);
        }
        const auto report = core::exportMask(volume, requestFor(format, file), {});
        QVERIFY(!report);
        QCOMPARE(report.error().code, core::ErrorCode::ExportMismatch);
        QCOMPARE(report.error().arguments.value(0), file);
        QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
    }
}

void ExportFaultsTest::faultInTheNiftiIsCaught_data()
{
    using Change = std::function<void(QByteArray&)>;
    QTest::addColumn<Change>("change");
    const auto affine = [](int row, int column) { return srow + 16 * row + 4 * column; };

    for (int axis = 0; axis < 3; ++axis) {
        QTest::addRow("flip of axis %d", axis) << Change([=](QByteArray& bytes) {
            for (int row = 0; row < 3; ++row)
                putFloat(bytes, affine(row, axis), -floatAt(bytes, affine(row, axis)));
        });
        QTest::addRow("flip of axis %d about the middle", axis) << Change([=](QByteArray& bytes) {
            const float count = float(glm::ivec3(11, 7, 6)[axis] - 1);
            for (int row = 0; row < 3; ++row) {
                const float step = floatAt(bytes, affine(row, axis));
                putFloat(bytes, affine(row, 3), floatAt(bytes, affine(row, 3)) + count * step);
                putFloat(bytes, affine(row, axis), -step);
            }
        });
        QTest::addRow("half a voxel along axis %d", axis) << Change([=](QByteArray& bytes) {
            for (int row = 0; row < 3; ++row)
                putFloat(bytes, affine(row, 3),
                    floatAt(bytes, affine(row, 3)) + 0.5F * floatAt(bytes, affine(row, axis)));
        });
        QTest::addRow("qform half a voxel along axis %d", axis) << Change([=](QByteArray& bytes) {
            const float step = glm::vec3(0.7F, 0.9F, 2.5F)[axis];
            putFloat(bytes, qoffset + 4 * axis, floatAt(bytes, qoffset + 4 * axis) + 0.5F * step);
        });
    }
    QTest::newRow("row and column spacing swapped") << Change([=](QByteArray& bytes) {
        putFloat(bytes, affine(0, 0), -0.9F);
        putFloat(bytes, affine(1, 1), -0.7F);
    });
    QTest::newRow("row and column spacing swapped in the qform") << Change([](QByteArray& bytes) {
        putFloat(bytes, pixdim + 4, 0.9F);
        putFloat(bytes, pixdim + 8, 0.7F);
    });
    QTest::newRow("qform turned") << Change(
        [](QByteArray& bytes) { putFloat(bytes, quaternion + 8, 0.0F); });
    QTest::newRow("one voxel") << Change(
        [](QByteArray& bytes) { bytes[voxelStart + 200] = char(bytes[voxelStart + 200] + 1); });
}

void ExportFaultsTest::faultInTheNiftiIsCaught()
{
    QFETCH(std::function<void(QByteArray&)>, change);
    QTemporaryDir folder;
    const core::Volume volume = freshSeries(folder.filePath(QStringLiteral("images")));
    const QString file = folder.filePath(QStringLiteral("seg.nii"));
    QVERIFY(core::exportMask(volume, requestFor(core::ExportFormat::Nifti, file), {}));
    QVERIFY(core::checkNiftiExport(file, expectationOf(volume), {}));
    alterNifti(file, change);
    const auto checked = core::checkNiftiExport(file, expectationOf(volume), {});
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, core::ErrorCode::ExportMismatch);
}

void ExportFaultsTest::faultOfTheVolumeIsCaught_data()
{
    using Change = std::function<void(core::Volume&)>;
    QTest::addColumn<Change>("change");
    QTest::newRow("loader flips rows") << Change([](core::Volume& volume) {
        glm::dmat4& affine = volume.geometry.indexToWorld;
        affine[3] += affine[1] * 6.0;
        affine[1] = -affine[1];
    });
    QTest::newRow("loader exchanges spacings") << Change([](core::Volume& volume) {
        volume.geometry.indexToWorld[0] *= 0.9 / 0.7;
        volume.geometry.indexToWorld[1] *= 0.7 / 0.9;
    });
    QTest::newRow("loader orders slices by name")
        << Change([](core::Volume& volume) { std::swap(volume.sources[1], volume.sources[4]); });
    QTest::newRow("loader counts from pixel corners") << Change([](core::Volume& volume) {
        volume.geometry.indexToWorld[3] -= volume.geometry.indexToWorld[0] * 0.5;
    });
}

void ExportFaultsTest::faultOfTheVolumeIsCaught()
{
    QFETCH(std::function<void(core::Volume&)>, change);
    QTemporaryDir folder;
    core::Volume volume = freshSeries(folder.filePath(QStringLiteral("images")));
    change(volume);
    for (const auto& [format, name] : formats) {
        const QString file = folder.filePath(QLatin1String(name));
        const auto report = core::exportMask(volume, requestFor(format, file), {});
        QVERIFY(!report);
        QCOMPARE(report.error().code, core::ErrorCode::ExportMismatch);
        QVERIFY(!QFile::exists(file));
    }
}

BURIN_TEST(ExportFaultsTest)

} // namespace exportFaultsTest

#include "ExportFaultsTest.moc"
