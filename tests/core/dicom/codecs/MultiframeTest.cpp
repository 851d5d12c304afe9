// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/codecs/EncodedFrame.h"
#include "core/dicom/header/ImageHeaderReader.h"
#include "core/study/StudyLoader.h"
#include "core/study/VolumeFacts.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/OpenedVolume.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <functional>

namespace multiframeTest {

using core::VolumeProblem;

namespace {

constexpr int columns = 6;
constexpr int rows = 5;
constexpr int slices = 4;
constexpr int times = 3;
constexpr int frames = slices * times;

struct Frame {
    int slice = 0;
    int time = 0;
};

/// Frames in no order: neither slice by slice nor time by time.
Frame frameAt(int index)
{
    const int shuffled = (index * 5 + 3) % frames;
    return {.slice = shuffled % slices, .time = shuffled / slices};
}

int storedAt(int column, int row, const Frame& frame)
{
    return column + 10 * row + 100 * frame.slice + 1000 * frame.time;
}

double slopeAt(const Frame& frame)
{
    return frame.time == 2 ? 2.0 : 0.5;
}

DcmItem* group(DcmDataset& set, const DcmTagKey& groups, long item, const DcmTagKey& macro)
{
    DcmItem* holder = nullptr;
    DcmItem* found = nullptr;
    set.findOrCreateSequenceItem(groups, holder, item);
    holder->findOrCreateSequenceItem(macro, found, 0);
    return found;
}

/// An Enhanced MR object of three points in time: orientation and pixel spacing shared, positions,
/// slopes and times frame by frame.
struct EnhancedFile {
    std::function<void(DcmDataset& set)> adjust = [](DcmDataset&) {};
    E_TransferSyntax syntax = EXS_LittleEndianExplicit;
    bool withPositions = true;

    void write(const QString& path) const
    {
        DcmFileFormat format;
        DcmDataset& set = *format.getDataset();
        const auto put = [&set](const DcmTagKey& key, const char* value) {
            set.putAndInsertString(key, value);
        };
        put(DCM_SOPClassUID, UID_EnhancedMRImageStorage);
        put(DCM_SOPInstanceUID, "2.25.5000.1");
        put(DCM_StudyInstanceUID, "2.25.5001");
        put(DCM_SeriesInstanceUID, "2.25.5002");
        put(DCM_FrameOfReferenceUID, "2.25.5003");
        put(DCM_Modality, "MR");
        put(DCM_ImageType, "ORIGINAL\\PRIMARY\\T2\\NONE");
        put(DCM_PhotometricInterpretation, "MONOCHROME2");
        put(DCM_NumberOfFrames, QByteArray::number(frames).constData());
        set.putAndInsertUint16(DCM_SamplesPerPixel, 1);
        set.putAndInsertUint16(DCM_Rows, rows);
        set.putAndInsertUint16(DCM_Columns, columns);
        set.putAndInsertUint16(DCM_BitsAllocated, 16);
        set.putAndInsertUint16(DCM_BitsStored, 16);
        set.putAndInsertUint16(DCM_HighBit, 15);
        set.putAndInsertUint16(DCM_PixelRepresentation, 0);
        const DcmTagKey shared = DCM_SharedFunctionalGroupsSequence;
        group(set, shared, 0, DCM_PlaneOrientationSequence)
            ->putAndInsertString(DCM_ImageOrientationPatient, "0\\1\\0\\0\\0\\-1");
        group(set, shared, 0, DCM_PixelMeasuresSequence)
            ->putAndInsertString(DCM_PixelSpacing, "0.8\\1.25");
        std::vector<Uint16> pixels;
        for (int index = 0; index < frames; ++index) {
            const Frame frame = frameAt(index);
            const DcmTagKey each = DCM_PerFrameFunctionalGroupsSequence;
            // The normal of this plane points to the right, against x.
            const double x = 20.0 - 2.5 * frame.slice;
            if (withPositions)
                group(set, each, index, DCM_PlanePositionSequence)
                    ->putAndInsertString(
                        DCM_ImagePositionPatient, (QByteArray::number(x) + "\\-7\\30").constData());
            DcmItem* content = group(set, each, index, DCM_FrameContentSequence);
            content->putAndInsertUint32(DCM_TemporalPositionIndex, Uint32(frame.time + 1));
            content->putAndInsertString(DCM_StackID, "1");
            // Real files contradict their positions here.
            content->putAndInsertUint32(DCM_InStackPositionNumber, Uint32(slices - frame.slice));
            DcmItem* values = group(set, each, index, DCM_PixelValueTransformationSequence);
            values->putAndInsertString(
                DCM_RescaleSlope, QByteArray::number(slopeAt(frame)).constData());
            values->putAndInsertString(DCM_RescaleIntercept, "-10");
            for (int row = 0; row < rows; ++row) {
                for (int column = 0; column < columns; ++column)
                    pixels.push_back(Uint16(storedAt(column, row, frame)));
            }
        }
        set.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
        adjust(set);
        if (set.chooseRepresentation(syntax, nullptr).bad()
            || format.saveFile(QFile::encodeName(path).constData(), syntax).bad())
            qFatal("cannot write %s", qPrintable(path));
    }
};

} // namespace

/// Enhanced multi-frame objects: places, values and times out of functional groups.
class MultiframeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { DcmRLEEncoderRegistration::registerCodecs(); }

    void everyFrameHasItsPlaceValueAndTime_data();
    void everyFrameHasItsPlaceValueAndTime();
    void framesWithoutPlacesAreRefusedInWords();
    void missingPixelsCostTheirFrames();
    void onlySharedGroupsAreRefusedInWords();
    void framesBeyondTheGroupsAreListed();
    void sourcesNameTheirFrames();
    void tornFramesAreJoined();
};

void MultiframeTest::everyFrameHasItsPlaceValueAndTime_data()
{
    QTest::addColumn<int>("syntax");
    QTest::newRow("explicit little endian") << int(EXS_LittleEndianExplicit);
    QTest::newRow("implicit") << int(EXS_LittleEndianImplicit);
    QTest::newRow("big endian") << int(EXS_BigEndianExplicit);
    QTest::newRow("deflated") << int(EXS_DeflatedLittleEndianExplicit);
    QTest::newRow("RLE") << int(EXS_RLELossless);
}

void MultiframeTest::everyFrameHasItsPlaceValueAndTime()
{
    QFETCH(int, syntax);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mf"));
    EnhancedFile{.syntax = E_TransferSyntax(syntax)}.write(file);
    const core::Result<core::Study> study = core::Study::scan(file);
    QVERIFY(study);
    QCOMPARE(study->listing().candidates().size(), std::size_t(1));
    const core::SeriesEntry& entry = *study->listing().candidates().front();
    QCOMPARE(QStringList(entry.times),
        (QStringList{QStringLiteral("temporal position 1"), QStringLiteral("temporal position 2"),
            QStringLiteral("temporal position 3")}));
    for (int time = 0; time < times; ++time) {
        const core::Result<core::LoadedVolume> loaded = study->load(entry.keyAtTime(time));
        QVERIFY(loaded);
        const core::VolumeGeometry& geometry = loaded->volume.geometry;
        QCOMPARE(geometry.size, glm::ivec3(columns, rows, slices));
        QCOMPARE(geometry.spacingMm(), glm::dvec3(1.25, 0.8, 2.5));
        QCOMPARE(geometry.originLps(), glm::dvec3(20.0, -7.0, 30.0));
        QCOMPARE(geometry.toWorld({0, 0, slices - 1}), glm::dvec3(12.5, -7.0, 30.0));
        for (int k = 0; k < slices; ++k) {
            const Frame frame{.slice = k, .time = time};
            for (int row = 0; row < rows; ++row) {
                for (int column = 0; column < columns; ++column) {
                    QCOMPARE(test::valueAt(*loaded, {column, row, k}),
                        slopeAt(frame) * storedAt(column, row, frame) - 10.0);
                }
            }
        }
    }
}

void MultiframeTest::framesWithoutPlacesAreRefusedInWords()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mf"));
    EnhancedFile{.withPositions = false}.write(file);
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(file);
    QVERIFY(!loaded);
    const QString why = loaded.error().arguments.value(1);
    QVERIFY2(why.contains(QLatin1String("no position in the patient for its 12 frames")),
        qPrintable(why));
}

void MultiframeTest::onlySharedGroupsAreRefusedInWords()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mf"));
    EnhancedFile{.adjust = [](DcmDataset& set) {
        set.findAndDeleteElement(DCM_PerFrameFunctionalGroupsSequence);
    }}.write(file);
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(file);
    QVERIFY(!loaded);
    const QString why = loaded.error().arguments.value(1);
    QVERIFY2(why.contains(QLatin1String("nothing says where each of its 12 frames lies")),
        qPrintable(why));
}

/// A file that says of its first frames only where they lie.
void MultiframeTest::framesBeyondTheGroupsAreListed()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mf"));
    EnhancedFile{.adjust = [](DcmDataset& set) {
        DcmSequenceOfItems* groups = nullptr;
        set.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, groups);
        for (int each = 0; each < 2; ++each)
            delete groups->remove(groups->card() - 1);
    }}.write(file);
    const core::Result<core::Study> study = core::Study::scan(file);
    QVERIFY(study);
    int left = 0;
    for (const core::SeriesEntry* entry : study->listing().candidates())
        left += entry->slices() * std::max(1, int(entry->times.size()));
    QCOMPARE(left, frames - 2);
    const std::vector<core::ForeignObject>& foreign = study->listing().foreign;
    QCOMPARE(foreign.size(), std::size_t(1));
    QCOMPARE(foreign.front().kind, QStringLiteral("image without a place"));
    QCOMPARE(foreign.front().reason,
        QStringLiteral("no position in the patient for 2 of its 12 frames"));
    QCOMPARE(foreign.front().files, QStringList{file});
}

void MultiframeTest::missingPixelsCostTheirFrames()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mf"));
    EnhancedFile().write(path);
    QFile file(path);
    QVERIFY(file.resize(file.size() - 2 * columns * rows - 7));
    const core::Result<core::Study> study = core::Study::scan(path);
    QVERIFY(study);
    // Two frames are gone: the places are not equally full any more.
    const auto candidates = study->listing().candidates();
    QVERIFY(!candidates.empty());
    int left = 0;
    for (const core::SeriesEntry* entry : candidates)
        left += entry->slices() * std::max(1, int(entry->times.size()));
    QCOMPARE(left, frames - 2);
    const QString text =
        test::problemText(candidates.front()->problems, VolumeProblem::Kind::DamagedSlice);
    QVERIFY2(text.contains(QLatin1String("mf frame 12")), qPrintable(text));
}

void MultiframeTest::sourcesNameTheirFrames()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mf"));
    EnhancedFile().write(file);
    const core::LoadedVolume loaded = test::openVolume(file, QStringLiteral("2.25.5002@2"));
    QCOMPARE(loaded.volume.sources.size(), std::size_t(slices));
    for (int k = 0; k < slices; ++k) {
        const core::SourceSlice& source = loaded.volume.sources[std::size_t(k)];
        const Frame frame = frameAt(source.frame);
        QCOMPARE(frame.slice, k);
        QCOMPARE(frame.time, 1);
        QCOMPARE(source.sopInstanceUid, QStringLiteral("2.25.5000.1"));
    }
}

void MultiframeTest::tornFramesAreJoined()
{
    using Bytes = std::vector<std::uint8_t>;
    const Bytes head{0xff, 0xd8, 0xff, 0xe0};
    const Bytes body{1, 2, 3};
    const Bytes tail{4, 0xff, 0xd9};
    const std::vector<core::DicomBytes> torn{head, body, tail, head, tail};
    const auto jpeg = [&](int frame, int count) {
        return core::encodedFrame(torn, frame, count, core::PixelCoding::Jpeg);
    };
    QCOMPARE(*jpeg(0, 2), (Bytes{0xff, 0xd8, 0xff, 0xe0, 1, 2, 3, 4, 0xff, 0xd9}));
    QCOMPARE(*jpeg(1, 2), (Bytes{0xff, 0xd8, 0xff, 0xe0, 4, 0xff, 0xd9}));
    // As many fragments as frames need no beginnings.
    QCOMPARE(*jpeg(1, 5), body);
    QCOMPARE(jpeg(0, 1)->size(), std::size_t(17));
    QVERIFY(!jpeg(0, 3));
    QVERIFY(!core::encodedFrame(torn, 0, 2, core::PixelCoding::Rle));
}

BURIN_TEST(MultiframeTest)

} // namespace multiframeTest

#include "MultiframeTest.moc"
