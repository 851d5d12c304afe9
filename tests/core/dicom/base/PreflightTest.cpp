// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/Preflight.h"

#include "core/dicom/codecs/FrameDecoder.h"
#include "core/dicom/header/ImageHeaderReader.h"
#include "core/dicom/objects/SegReader.h"
#include "core/dicom/source/VisitSourceFiles.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/defective/HostileDicom.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QTemporaryDir>
#include <QTest>

#include <sys/resource.h>

#include <algorithm>
#include <random>

namespace preflightTest {

namespace {

const char* const syntaxes[] = {"1.2.840.10008.1.2", "1.2.840.10008.1.2.1",
    "1.2.840.10008.1.2.1.99", "1.2.840.10008.1.2.2", "1.2.840.10008.1.2.5",
    "1.2.840.10008.1.2.4.70", "1.2.840.10008.1.2.4.80"};

QByteArray contents(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("cannot read %s", qPrintable(path));
    return file.readAll();
}

void store(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

core::DicomBytes bytesOf(const QByteArray& bytes)
{
    return {reinterpret_cast<const std::uint8_t*>(bytes.constData()), std::size_t(bytes.size())};
}

/// The most memory that this process ever had, in KB.
long peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

QString sentence(const core::Error& error)
{
    return error.arguments.mid(1).join(QLatin1Char(' '));
}

/// Every way in which a file comes before DCMTK. None may crash; who fails says why.
void openEveryWay(const QString& file)
{
    const core::Result<core::ImageHeader> header = core::readImageHeader(file);
    if (!header)
        QVERIFY(header.error().arguments.size() >= 2);
    const core::Result<core::SegFile> seg = core::readSeg(file);
    if (!seg)
        QVERIFY(seg.error().arguments.size() >= 2);
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(file);
    if (!loaded)
        QVERIFY(!loaded.error().arguments.isEmpty());
}

/// How deep DCMTK has nested sequences and items in this object.
int depthOf(DcmObject& object)
{
    struct Place {
        DcmObject* object;
        int depth;
    };
    std::vector<Place> open{{&object, 1}};
    int deepest = 0;
    while (!open.empty()) {
        const Place place = open.back();
        open.pop_back();
        deepest = std::max(deepest, place.depth);
        for (DcmObject* inner = place.object->nextInContainer(nullptr); inner != nullptr;
             inner = place.object->nextInContainer(inner)) {
            if (!inner->isLeaf())
                open.push_back({inner, place.depth + 1});
        }
    }
    return deepest;
}

} // namespace

/// No file hurts: what DCMTK would crash on, or hang, is refused with a sentence before it sees it.
class PreflightTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_folder.isValid()); }

    void hostileFilesAreRefused_data();
    void hostileFilesAreRefused();
    void hostileFileCostsOneSlice();
    void jpegWithoutEndCostsOneSlice();
    void deflatedPixelsAreInflatedOnlyAsFarAsNeeded();
    void headersThatASessionHoldsAreChecked();
    void unreadableWaysOfNestingAreFound();
    void promisedImageIsCounted();
    void offsetTableIsJudged();
    void wrongNameOfTheLittleEndianFormIsMended();
    void truncationsAreSurvived_data() { addSyntaxes(); }
    void truncationsAreSurvived();
    void flippedBytesAreSurvived_data() { addSyntaxes(); }
    void flippedBytesAreSurvived();
    void randomBytesAreSurvived();
    void dcmtkNestsNoDeeper();

private:
    static void addSyntaxes();
    /// A small honest file in this syntax, with a sequence.
    QByteArray honest(const QString& syntax);
    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name));
    }

    QTemporaryDir m_folder;
};

void PreflightTest::addSyntaxes()
{
    QTest::addColumn<QString>("syntax");
    for (const char* uid : syntaxes)
        QTest::newRow(uid) << QString::fromLatin1(uid);
}

QByteArray PreflightTest::honest(const QString& syntax)
{
    test::SyntheticSeries series;
    series.size = {16, 12, 1};
    series.transferSyntaxUid = syntax;
    series.adjust = [](DcmDataset& set, int) {
        DcmItem* item = nullptr;
        set.findOrCreateSequenceItem(DCM_ReferencedSeriesSequence, item, 0);
        DcmItem* inner = nullptr;
        item->findOrCreateSequenceItem(DCM_ReferencedInstanceSequence, inner, -2);
        inner->putAndInsertString(DCM_ReferencedSOPInstanceUID, "2.25.77");
    };
    return contents(test::writeSeries(series, path("honest")).front());
}

void PreflightTest::hostileFilesAreRefused_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("reason");
    for (const test::HostileDicom& hostile : test::hostileDicoms(honest(syntaxes[1])))
        QTest::newRow(hostile.name) << hostile.bytes << QString::fromUtf8(hostile.reason);
}

void PreflightTest::hostileFilesAreRefused()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, reason);
    const QString file = path("hostile.dcm");
    store(file, bytes);
    const long before = peakMemory();
    openEveryWay(file);
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(file);
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().arguments.value(0), file);
    QVERIFY2(sentence(loaded.error()).contains(reason), qPrintable(sentence(loaded.error())));
    // The bombs alone would take more; the largest of these files has 17 MB.
    QVERIFY2(peakMemory() - before < 200'000, qPrintable(QString::number(peakMemory() - before)));
}

void PreflightTest::hostileFileCostsOneSlice()
{
    const QString folder = path("series");
    test::SyntheticSeries series;
    test::writeSeries(series, folder);
    const std::vector<test::HostileDicom> all = test::hostileDicoms(honest(syntaxes[1]));
    std::size_t refused = 0;
    for (const test::HostileDicom& hostile : all) {
        if (!hostile.onlyWhenDecoded)
            store(QStringLiteral("%1/hostile%2").arg(folder).arg(refused++), hostile.bytes);
    }
    const core::Result<core::StudyListing> listing = core::scanStudies(folder);
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(1));
    QVERIFY(!listing->unreadable.empty());
    for (const core::UnreadableFile& file : listing->unreadable) {
        QVERIFY(file.file.contains(QLatin1String("hostile")));
        QVERIFY(!sentence(file.error).isEmpty());
    }
    QCOMPARE(listing->unreadable.size(), refused);
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(folder);
    QVERIFY(loaded);
    QCOMPARE(loaded->volume.geometry.size.z, series.size.z);
}

void PreflightTest::jpegWithoutEndCostsOneSlice()
{
    const QString folder = path("jpeg");
    test::SyntheticSeries series;
    series.transferSyntaxUid = QStringLiteral("1.2.840.10008.1.2.4.70");
    const QString file = test::writeSeries(series, folder).at(3);
    QByteArray bytes = contents(file);
    const qsizetype at = bytes.lastIndexOf(QByteArray("\xff\xd8\xff", 3));
    QVERIFY(at > 0);
    // The fragment grows by the TEM marker, on which DCMTK never comes to an end.
    bytes.insert(at + 2, QByteArray("\xff\x01", 2));
    const std::uint32_t length = core::readUint32(bytesOf(bytes), std::size_t(at) - 4, false);
    bytes.replace(at - 4, 4, test::words({length + 2}));
    store(file, bytes);
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(folder);
    QVERIFY(loaded);
    QCOMPARE(int(loaded->volume.sources.size()), series.size.z - 1);
    QVERIFY(loaded->volume.needsCaution());
}

void PreflightTest::deflatedPixelsAreInflatedOnlyAsFarAsNeeded()
{
    const QByteArray bomb = test::deflatedBomb(12, 16);
    const QString file = path("bomb.dcm");
    store(file, bomb);
    const long before = peakMemory();
    const core::Result<core::ImageHeader> header = core::readImageHeader(file);
    QVERIFY(header);
    std::vector<std::uint16_t> stored(12 * 16, 7);
    const core::Result<core::DecodedFrame> decoded = core::decodeFrame(*header, stored);
    QVERIFY2(decoded, decoded ? "" : qPrintable(sentence(decoded.error())));
    QVERIFY(std::all_of(stored.begin(), stored.end(), [](int value) { return value == 0; }));
    QVERIFY(peakMemory() - before < 50'000);
}

/// Whoever makes a session file can put anything where the headers of its study stand.
void PreflightTest::headersThatASessionHoldsAreChecked()
{
    QByteArray nest;
    for (int depth = 0; depth < 100000; ++depth)
        nest += QByteArray::fromHex("08004011"
                                    "5351"
                                    "0000"
                                    "ffffffff"
                                    "feff00e0"
                                    "ffffffff");
    const QString file = QStringLiteral("slice.dcm");
    core::KeptHeaders kept;
    kept[file] = nest;
    std::vector<core::SourceSlice> slices(1);
    slices.front().file = file;
    bool taken = false;
    const auto take = [&taken](const QString&, DcmDataset&, const std::vector<std::size_t>&) {
        taken = true;
        return core::Result<void>();
    };
    const auto visited = core::visitSourceFiles(slices, &kept, {}, take);
    QVERIFY(!visited && !taken);
    QCOMPARE(visited.error().arguments.value(0), file);
    QVERIFY2(visited.error().arguments.value(1).contains(QStringLiteral("nest")),
        qPrintable(visited.error().arguments.join(u' ')));
}

void PreflightTest::unreadableWaysOfNestingAreFound()
{
    // Sequences that only one of two readings of the bytes shows.
    for (const test::HostileDicom& hidden : test::hiddenNests()) {
        const QString file = path("hidden.dcm");
        store(file, hidden.bytes);
        openEveryWay(file);
        const QString reason = QString::fromLatin1(hidden.reason);
        if (reason.isEmpty())
            continue;
        const core::Result<core::ImageHeader> header = core::readImageHeader(file);
        QVERIFY2(!header, hidden.name);
        QVERIFY2(sentence(header.error()).contains(reason), qPrintable(sentence(header.error())));
    }
}

void PreflightTest::promisedImageIsCounted()
{
    core::PromisedImage image{.columns = 65535,
        .rows = 65535,
        .samplesPerPixel = 65535,
        .bitsAllocated = 65535,
        .frames = 1};
    QCOMPARE(image.frameBytes(), std::uint64_t(18445618199572250625ULL / 8 + 1));
    QVERIFY(image.bytes());
    image.frames = 9;
    QVERIFY(!image.bytes());
    image = {.columns = 3, .rows = 3, .bitsAllocated = 1, .frames = 4};
    QCOMPARE(*image.bytes(), std::uint64_t(8));
}

void PreflightTest::offsetTableIsJudged()
{
    const auto judged = [&](const QByteArray& table) {
        const QByteArray set = test::explicitElement(0x00280010, "US", QByteArray("\x02\0", 2))
            + test::encapsulated({table, QByteArray(6, 'a'), QByteArray(10, 'b')});
        const core::Result<core::PreflightFacts> facts =
            core::preflight(bytesOf(set), {}, QStringLiteral("x"));
        if (!facts || facts->fragments.size() != 2)
            qFatal("no facts");
        return facts->offsetTableSound;
    };
    QVERIFY(judged({}));
    QVERIFY(judged(test::words({0})));
    QVERIFY(judged(test::words({0, 14})));
    QVERIFY(!judged(test::words({0, 15})));
    QVERIFY(!judged(test::words({14, 0})));
    QVERIFY(!judged(test::words({0, 0xfffffff0u})));
    QVERIFY(!judged(QByteArray(3, '\0')));
}

void PreflightTest::wrongNameOfTheLittleEndianFormIsMended()
{
    for (const bool explicitVr : {false, true}) {
        QByteArray bytes = honest(QString::fromLatin1(syntaxes[explicitVr ? 1 : 0]));
        const QByteArray right = explicitVr ? QByteArray("1.2.840.10008.1.2.1\0", 20)
                                            : QByteArray("1.2.840.10008.1.2\0", 18);
        const qsizetype at = bytes.indexOf(right);
        QVERIFY(at > 0);
        // As long as the right one, so that no length changes.
        QByteArray wrong = explicitVr ? QByteArray("1.2.840.10008.1.2\0\0\0", 20)
                                      : QByteArray("1.2.840.10008.1.9\0", 18);
        bytes.replace(at, right.size(), wrong);
        const QString file = path("misnamed.dcm");
        store(file, bytes);
        const core::Result<core::ImageHeader> header = core::readImageHeader(file);
        QVERIFY2(header, header ? "" : qPrintable(sentence(header.error())));
        QCOMPARE(header->layout.columns, 16);
        QVERIFY(header->hasPixels);
    }
}

void PreflightTest::truncationsAreSurvived()
{
    QFETCH(QString, syntax);
    const QByteArray bytes = honest(syntax);
    const QString file = path("cut.dcm");
    const qsizetype step = test::longRun() ? 1 : 3;
    int refused = 0;
    for (qsizetype size = 0; size < bytes.size(); size += step) {
        store(file, bytes.left(size));
        const core::Result<core::ImageHeader> header = core::readImageHeader(file);
        if (!header) {
            ++refused;
            QVERIFY(!sentence(header.error()).isEmpty());
            continue;
        }
        if (header->layout.rows != 12 || header->layout.columns != 16)
            continue;
        std::vector<std::uint16_t> stored(12 * 16);
        if (const core::Result<core::DecodedFrame> decoded = core::decodeFrame(*header, stored);
            !decoded)
            QVERIFY(!sentence(decoded.error()).isEmpty());
    }
    QVERIFY(refused > 10);
}

void PreflightTest::flippedBytesAreSurvived()
{
    QFETCH(QString, syntax);
    const QByteArray bytes = honest(syntax);
    const QString file = path("flipped.dcm");
    const int rounds = test::longRun() ? 20'000 : 300;
    std::mt19937 random(20261122);
    for (int round = 0; round < rounds; ++round) {
        QByteArray damaged = bytes;
        for (int change = 1 + int(random() % 8); change > 0; --change) {
            const qsizetype at = 128 + qsizetype(random() % quint32(bytes.size() - 128));
            // Lengths and delimiters hurt more than noise.
            const char choices[] = {char(random()), '\xff', '\0', '\xfe', char(damaged[at] ^ 1)};
            damaged[at] = choices[random() % 5];
        }
        store(file, damaged);
        openEveryWay(file);
        if (QTest::currentTestFailed())
            return;
    }
}

void PreflightTest::randomBytesAreSurvived()
{
    const int rounds = test::longRun() ? 200'000 : 5'000;
    std::mt19937 random(4711);
    const QByteArray pieces[] = {QByteArray("\xfe\xff\x00\xe0", 4),
        QByteArray("\xfe\xff\x0d\xe0", 4), QByteArray("\xfe\xff\xdd\xe0", 4), QByteArray(4, '\xff'),
        QByteArray("SQ\0\0", 4), QByteArray("UN\0\0", 4), QByteArray("\xe0\x7f\x10\x00OW", 6),
        QByteArray(4, '\0')};
    int passed = 0;
    for (int round = 0; round < rounds; ++round) {
        QByteArray bytes("\x08\x00\x15\x11", 4);
        for (int piece = int(random() % 60); piece > 0; --piece) {
            if (random() % 3 == 0)
                bytes.append(char(random()));
            else
                bytes.append(pieces[random() % 8]);
        }
        const core::DataSetForm form{
            .explicitVr = random() % 2 == 0, .bigEndian = random() % 4 == 0};
        const core::Result<core::PreflightFacts> facts =
            core::preflight(bytesOf(bytes), form, QStringLiteral("random"));
        if (!facts) {
            QVERIFY(!sentence(facts.error()).isEmpty());
            continue;
        }
        ++passed;
        for (const core::ByteRange& fragment : facts->fragments)
            QVERIFY(fragment.at + fragment.size <= std::size_t(bytes.size()));
        QVERIFY(
            facts->pixelsCut || facts->pixels.at + facts->pixels.size <= std::size_t(bytes.size()));
    }
    QVERIFY(passed < rounds);
}

/// Whatever passes is nested by DCMTK no deeper than the bound says, also where bytes can be read
/// in more than one way.
void PreflightTest::dcmtkNestsNoDeeper()
{
    const int rounds = test::longRun() ? 100'000 : 3'000;
    std::mt19937 random(815);
    int passed = 0;
    for (int round = 0; round < rounds; ++round) {
        const bool explicitVr = random() % 2 == 0;
        const QByteArray set = test::randomDataSet(random, explicitVr);
        const core::DataSetForm form{.explicitVr = explicitVr};
        if (!core::preflight(bytesOf(set), form, QStringLiteral("random")))
            continue;
        ++passed;
        DcmInputBufferStream stream;
        stream.setBuffer(set.constData(), offile_off_t(set.size()));
        stream.setEos();
        DcmDataset parsed;
        parsed.transferInit();
        parsed.readUntilTag(stream,
            explicitVr ? EXS_LittleEndianExplicit : EXS_LittleEndianImplicit, EGL_noChange, 1024,
            DCM_PixelData);
        parsed.transferEnd();
        QVERIFY2(depthOf(parsed) <= 65, set.toHex().constData());
    }
    QVERIFY2(passed > 0 && passed < rounds, qPrintable(QString::number(passed)));
}

BURIN_TEST(PreflightTest)

} // namespace preflightTest

#include "PreflightTest.moc"
