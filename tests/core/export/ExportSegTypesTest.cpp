// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SegReader.h"
#include "core/export/common/CheckExport.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/LabelledSeries.h"
#include "tests/support/servers/Python.h"
#include "ui/texts/ReportTexts.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <random>

namespace exportSegTypesTest {

namespace {

core::CodedConcept sct(const char* value, const char* meaning)
{
    return {.scheme = QStringLiteral("SCT"),
        .value = QLatin1String(value),
        .meaning = QLatin1String(meaning)};
}

core::Segment segmentOf(int label, const char* name)
{
    core::Segment segment;
    segment.label = std::uint8_t(label);
    segment.name = QString::fromUtf8(name);
    segment.rgb = 0x3399ff;
    segment.code = sct("64033007", "Kidney");
    return segment;
}

QJsonArray asJson(const core::CodedConcept& code)
{
    return {QJsonValue(QJsonArray{code.scheme, code.value, code.meaning})};
}

QString messageOf(const core::Error& error)
{
    return QString::number(int(error.code)) + QLatin1Char(' ')
        + error.arguments.join(QStringLiteral(" | "));
}

/// A series of uneven width on disk with labels, and the coverage of a layer that segment 1 was
/// made of, parted from it in some voxels since.
struct Made {
    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("seg.dcm"));
    core::Volume volume;
    std::vector<std::uint8_t> labels;
    std::vector<std::uint8_t> coverage;
    std::vector<core::LabelPlaneView> planes;
    glm::ivec3 size{11, 7, 6};
    std::size_t area = 0;

    Made()
    {
        test::SmallSeries series;
        series.size = size;
        series.placeEvenly({0, 0, 10}, {0, 0, 2.5});
        volume = series.write(folder.filePath(QStringLiteral("images")));
        area = std::size_t(series.size.x) * std::size_t(series.size.y);
        std::mt19937 random(7);
        for (std::size_t i = 0; i < volume.geometry.voxelCount(); ++i) {
            const std::size_t k = i / area;
            coverage.push_back(k == 0 || k > 4 ? 0 : std::uint8_t(random() % 256));
            // The first layer's lower rim is thinner than half a voxel everywhere.
            if (k == 1)
                coverage.back() /= 3;
            const unsigned dice = random() % 10;
            labels.push_back(coverage.back() >= 128 && dice > 0 ? 1 : 0);
            if (labels.back() == 0 && dice == 9)
                labels.back() = k == 0 ? 0 : random() % 2 == 0 ? 1 : 2;
        }
        planes = {{.plane = 0, .labels = labels}};
    }

    [[nodiscard]] core::ExportRequest request(core::ExportFormat format) const
    {
        return {.format = format,
            .file = file,
            .segments = {segmentOf(1, "Niere"), segmentOf(2, "Übrige")},
            .planes = planes};
    }
    [[nodiscard]] std::uint8_t share(int label, std::size_t i) const
    {
        const bool inside = labels[i] == label;
        if (label != 1)
            return inside ? 255 : 0;
        if (inside)
            return coverage[i] >= 128 ? coverage[i] : 255;
        return coverage[i] < 128 && touchesCut(label, i) ? coverage[i] : 0;
    }
    /// Whether one of the 26 voxels around it is of that segment, and cut.
    [[nodiscard]] bool touchesCut(int label, std::size_t i) const
    {
        for (std::size_t other = 0; other < labels.size(); ++other) {
            const glm::ivec3 apart = glm::abs(placeOf(other) - placeOf(i));
            if (labels[other] == label && coverage[other] >= 128
                && std::max({apart.x, apart.y, apart.z}) == 1)
                return true;
        }
        return false;
    }
    [[nodiscard]] glm::ivec3 placeOf(std::size_t i) const
    {
        const int voxel = int(i);
        return {voxel % size.x, voxel / size.x % size.y, voxel / (size.x * size.y)};
    }
};

QJsonObject factsOf(const QString& file)
{
    const auto read = test::runScript(QStringLiteral("seg_pixels.py"), {file});
    if (read.exitCode != 0)
        qWarning("%s", qPrintable(read.errors));
    return QJsonDocument::fromJson(read.output).object();
}

QString sha256(const QByteArray& bytes)
{
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
}

} // namespace

/// DICOM SEG beside BINARY: fractional, label maps; deflated; what segments are, in full.
class ExportSegTypesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void othersSeeTheSame_data();
    void othersSeeTheSame();
    void fractionalHoldsTheCoverage();
    void holesOfLaterLeaveNoRim();
    void fractionalWithoutCoverageIsWhole();
    void labelMap();
    void labelMapHoldsNoOverlap();
    void deflated_data();
    void deflated();
    void codesInFull();
    void byHandNamesNoAlgorithm();
    void codeThatDicomCannotHold();
    void aByteThatIsWrongIsFound_data();
    void aByteThatIsWrongIsFound();

private:
    void validate(const QString& file);
};

void ExportSegTypesTest::validate(const QString& file)
{
    const auto result = test::runProgram(QStringLiteral("dciodvfy"), {file});
    const QByteArray text = result.output;
    QVERIFY2(result.exitCode == 0 && !text.contains("Error"), text.constData());
}

void ExportSegTypesTest::othersSeeTheSame_data()
{
    QTest::addColumn<core::ExportFormat>("format");
    QTest::addColumn<QString>("placement");
    for (const test::SeriesPlacement& placement : test::seriesPlacements()) {
        const QString name = QString::fromLatin1(placement.name);
        QTest::addRow("fractional, %s", placement.name)
            << core::ExportFormat::DicomSegFractional << name;
        QTest::addRow("label map, %s", placement.name)
            << core::ExportFormat::DicomSegLabelMap << name;
    }
}

/// The voxels and their places, however the series lies: DICOM SEG of the two other types.
void ExportSegTypesTest::othersSeeTheSame()
{
    QFETCH(core::ExportFormat, format);
    QFETCH(QString, placement);
    const test::SmallSeries series = test::placementOf(placement).series;
    std::mt19937 random(11);
    std::vector<std::uint8_t> some(
        std::size_t(series.size.x) * std::size_t(series.size.y) * std::size_t(series.size.z));
    for (auto& label : some)
        label = std::uint8_t(random() % 3);
    const test::LabelledSeries on(series, some);
    const QString file = on.folder.filePath(QStringLiteral("seg.dcm"));
    const auto report = core::exportMask(on.volume,
        {.format = format,
            .file = file,
            .segments = {segmentOf(1, "Niere"), segmentOf(2, "Übrige")},
            .planes = on.planes},
        {});
    QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
    const auto read = test::runScript(QStringLiteral("seg_facts.py"), {file, on.images});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    const bool fractional = format == core::ExportFormat::DicomSegFractional;
    const auto expected = [&](std::uint8_t label) {
        QByteArray mask;
        for (const std::uint8_t voxel : on.labels)
            mask += voxel == label ? char(fractional ? 255 : 1) : '\0';
        return sha256(mask);
    };
    QCOMPARE(facts["sha256"].toArray(), (QJsonArray{expected(1), expected(2)}));
    QCOMPARE(facts["referenced"].toInt(), series.size.z);
    QCOMPARE(facts["frameOfReference"].toString(), on.volume.identity.frameOfReferenceUid);
    if (fractional)
        validate(file);
}

void ExportSegTypesTest::fractionalHoldsTheCoverage()
{
    const Made on;
    core::ExportRequest request = on.request(core::ExportFormat::DicomSegFractional);
    request.coverages = {
        {.label = 1, .layer = QStringLiteral("Sculpt 1"), .coverage = on.coverage}};
    const auto report = core::exportMask(on.volume, request, {});
    QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
    QVERIFY(ui::reportTexts(report->written)
                .join(u' ')
                .contains(QStringLiteral("'Niere' as sculpt layer 'Sculpt 1'")));
    QVERIFY(ui::reportTexts(report->written)
                .join(u' ')
                .contains(QStringLiteral("every voxel 0 or 255: 'Übrige'")));

    const QJsonObject facts = factsOf(on.file);
    QCOMPARE(facts["type"].toString(), QStringLiteral("FRACTIONAL"));
    QCOMPARE(facts["fractionalType"].toString(), QStringLiteral("OCCUPANCY"));
    QCOMPARE(facts["full"].toInt(), 255);
    QCOMPARE(facts["bits"].toArray(), (QJsonArray{8, 8, 7}));
    std::size_t frames = 0;
    bool both = false;
    for (const int label : {1, 2}) {
        for (std::size_t k = 0; k < 6; ++k) {
            QByteArray bytes;
            for (std::size_t i = k * on.area; i < (k + 1) * on.area; ++i) {
                bytes += char(on.share(label, i));
                both = both || (on.share(1, i) != 0 && on.share(2, i) != 0);
                // Whoever takes half as the border finds the segment.
                QCOMPARE(on.share(label, i) >= 128, on.labels[i] == label);
            }
            if (bytes.count('\0') == bytes.size())
                continue;
            const QJsonObject frame = facts["frames"].toArray()[int(frames++)].toObject();
            QCOMPARE(frame["segment"].toInt(), label);
            QCOMPARE(frame["z"].toDouble(), 10 + 2.5 * double(k));
            QCOMPARE(frame["sha256"].toString(), sha256(bytes));
        }
    }
    QCOMPARE(std::size_t(facts["frames"].toArray().size()), frames);
    QVERIFY(both);
    QCOMPARE(facts["overlap"].toString(), QStringLiteral("YES"));
    validate(on.file);
}

/// A segment is made from a layer with two holes and one of them is erased from it; then a third
/// hole is drilled into the layer.
void ExportSegTypesTest::holesOfLaterLeaveNoRim()
{
    Made on;
    const auto at = [&on](int x, int y, int z) {
        return (std::size_t(z) * std::size_t(on.size.y) + std::size_t(y)) * std::size_t(on.size.x)
            + std::size_t(x);
    };
    std::fill(on.labels.begin(), on.labels.end(), std::uint8_t(0));
    std::fill(on.coverage.begin(), on.coverage.end(), std::uint8_t(0));
    constexpr std::uint8_t cut = 255;
    constexpr std::uint8_t rim = 90;
    // Bars of three voxels along z, with what is covered in part beside them: the segment's, the
    // one that was drilled later, the erased one.
    for (const int x : {1, 5, 9}) {
        for (int z = 1; z < 4; ++z) {
            for (int aside = -1; aside < 2; ++aside)
                on.coverage[at(x + aside, 3, z)] = aside == 0 ? cut : rim;
            on.labels[at(x, 3, z)] = x == 1 ? 1 : 0;
        }
    }
    core::ExportRequest request = on.request(core::ExportFormat::DicomSegFractional);
    request.segments.resize(1);
    request.coverages = {
        {.label = 1, .layer = QStringLiteral("Sculpt 1"), .coverage = on.coverage}};
    const auto report = core::exportMask(on.volume, request, {});
    QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
    const auto seg = core::readSeg(on.file);
    QVERIFY(seg);
    QCOMPARE(seg->frames.size(), std::size_t(3));
    for (std::size_t frame = 0; frame < seg->frames.size(); ++frame) {
        for (int row = 0; row < on.size.y; ++row) {
            for (int column = 0; column < on.size.x; ++column) {
                const bool isCut = row == 3 && column == 1;
                const bool isRim = row == 3 && (column == 0 || column == 2);
                QCOMPARE(int(seg->value(frame, column, row)), isCut ? cut : isRim ? rim : 0);
            }
        }
    }
}

void ExportSegTypesTest::fractionalWithoutCoverageIsWhole()
{
    const Made on;
    const auto report =
        core::exportMask(on.volume, on.request(core::ExportFormat::DicomSegFractional), {});
    QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
    const auto seg = core::readSeg(on.file);
    QVERIFY(seg);
    QCOMPARE(seg->type, core::SegFile::Type::Fractional);
    for (const std::uint8_t byte : seg->bits)
        QVERIFY(byte == 0 || byte == 255);
    QCOMPARE(seg->segmentsOverlap, QStringLiteral("NO"));
    validate(on.file);
}

void ExportSegTypesTest::labelMap()
{
    const Made on;
    core::ExportRequest request = on.request(core::ExportFormat::DicomSegLabelMap);
    const auto report = core::exportMask(on.volume, request, {});
    QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
    QVERIFY(
        ui::reportTexts(report->cautions).join(u' ').contains(QStringLiteral("supplement 243")));
    const QJsonObject facts = factsOf(on.file);
    QCOMPARE(facts["class"].toString(), QStringLiteral("1.2.840.10008.5.1.4.1.1.66.7"));
    QCOMPARE(facts["type"].toString(), QStringLiteral("LABELMAP"));
    QCOMPARE(facts["patientName"].toString(), QStringLiteral("Müller^Jörg"));
    QCOMPARE(facts["dimensions"].toArray(), QJsonArray{QStringLiteral("(0020, 0032)")});
    const QJsonArray segments = facts["segments"].toArray();
    QCOMPARE(segments.size(), 3);
    QCOMPARE(segments[0]["number"].toInt(), 0);
    QCOMPARE(segments[0]["label"].toString(), QStringLiteral("Background"));
    QCOMPARE(segments[2]["label"].toString(), QStringLiteral("Übrige"));
    QCOMPARE(segments[2]["lab"].toArray().size(), 3);
    int frames = 0;
    for (std::size_t k = 0; k < 6; ++k) {
        const QByteArray bytes(
            reinterpret_cast<const char*>(on.labels.data() + k * on.area), qsizetype(on.area));
        if (bytes.count('\0') == bytes.size())
            continue;
        const QJsonObject frame = facts["frames"].toArray()[frames++].toObject();
        QCOMPARE(frame["segment"].toInt(), 0);
        QCOMPARE(frame["indices"].toArray(), QJsonArray{int(k) + 1});
        QCOMPARE(frame["sha256"].toString(), sha256(bytes));
    }
    QCOMPARE(facts["frames"].toArray().size(), frames);
    // It was made before label maps: all that it finds fault with is their class and number 0.
    const auto verified = test::runProgram(QStringLiteral("dciodvfy"), {on.file});
    for (const QByteArray& line : verified.output.split('\n'))
        QVERIFY2(!line.contains("Error") || line.contains("SOP Class")
                || line.contains("Information Object Not found")
                || line.contains("SegmentNumber of 0"),
            line.constData());
}

void ExportSegTypesTest::labelMapHoldsNoOverlap()
{
    Made on;
    const std::vector<std::uint8_t> second(on.labels.size(), 2);
    on.planes.push_back({.plane = 1, .labels = second});
    core::ExportRequest request = on.request(core::ExportFormat::DicomSegLabelMap);
    request.segments[1].plane = 1;
    const auto report = core::exportMask(on.volume, request, {});
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::UnsupportedFormat);
    const auto shared = std::count(on.labels.begin(), on.labels.end(), std::uint8_t(1));
    QVERIFY(shared > 0);
    QVERIFY2(report.error().arguments.value(1).startsWith(
                 QStringLiteral("'Niere' and 'Übrige' overlap in %1 voxels, which one DICOM SEG ")
                     .arg(shared)),
        qPrintable(report.error().arguments.value(1)));
    QVERIFY(!QFile::exists(on.file));
}

void ExportSegTypesTest::deflated_data()
{
    QTest::addColumn<core::ExportFormat>("format");
    QTest::newRow("binary") << core::ExportFormat::DicomSeg;
    QTest::newRow("fractional") << core::ExportFormat::DicomSegFractional;
    QTest::newRow("label map") << core::ExportFormat::DicomSegLabelMap;
}

void ExportSegTypesTest::deflated()
{
    QFETCH(core::ExportFormat, format);
    const Made on;
    core::ExportRequest request = on.request(format);
    request.coverages = {
        {.label = 1, .layer = QStringLiteral("Sculpt 1"), .coverage = on.coverage}};
    QVERIFY(core::exportMask(on.volume, request, {}));
    const QJsonArray plain = factsOf(on.file)["frames"].toArray();
    const qint64 size = QFileInfo(on.file).size();
    request.seg.deflated = true;
    request.force = true;
    const auto report = core::exportMask(on.volume, request, {});
    QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
    const QJsonObject facts = factsOf(on.file);
    QCOMPARE(facts["syntax"].toString(), QStringLiteral("1.2.840.10008.1.2.1.99"));
    QCOMPARE(facts["frames"].toArray(), plain);
    QVERIFY(QFileInfo(on.file).size() < size);
}

void ExportSegTypesTest::codesInFull()
{
    const Made on;
    for (const core::ExportFormat format :
        {core::ExportFormat::DicomSeg, core::ExportFormat::DicomSegLabelMap}) {
        core::ExportRequest request = on.request(format);
        request.force = true;
        request.seg.algorithm = core::SegAlgorithm::Automatic;
        request.seg.algorithmName = QStringLiteral("Nierenfänger 2");
        const core::SegCodes codes{.category = sct("49755003", "Morphologically Altered Structure"),
            .modifier = sct("24028007", "Right"),
            .region = sct("10200004", "Liver"),
            .regionModifier = sct("7771000", "Left")};
        request.seg.codes[2] = codes;
        const auto report = core::exportMask(on.volume, request, {});
        QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
        const QJsonArray segments = factsOf(on.file)["segments"].toArray();
        const QJsonObject plain = segments[segments.size() - 2].toObject();
        const QJsonObject full = segments.last().toObject();
        QCOMPARE(plain["category"].toArray(), asJson(core::anatomicalStructure()));
        QVERIFY(plain["modifier"].toArray().isEmpty() && plain["region"].toArray().isEmpty());
        QCOMPARE(full["category"].toArray(), asJson(codes.category));
        QCOMPARE(full["type"].toArray(), asJson(sct("64033007", "Kidney")));
        QCOMPARE(full["modifier"].toArray(), asJson(codes.modifier));
        QCOMPARE(full["region"].toArray(), asJson(codes.region));
        QCOMPARE(full["regionModifier"].toArray(), asJson(codes.regionModifier));
        QCOMPARE(full["algorithm"].toArray(),
            (QJsonArray{QStringLiteral("AUTOMATIC"), QStringLiteral("Nierenfänger 2")}));
        if (format == core::ExportFormat::DicomSeg)
            validate(on.file);
    }
}

void ExportSegTypesTest::byHandNamesNoAlgorithm()
{
    const Made on;
    core::ExportRequest request = on.request(core::ExportFormat::DicomSeg);
    request.seg.algorithm = core::SegAlgorithm::Manual;
    QVERIFY(core::exportMask(on.volume, request, {}));
    QCOMPARE(factsOf(on.file)["segments"][0]["algorithm"].toArray(),
        (QJsonArray{QStringLiteral("MANUAL"), QString()}));
    validate(on.file);
}

void ExportSegTypesTest::codeThatDicomCannotHold()
{
    const Made on;
    for (const core::ExportFormat format :
        {core::ExportFormat::DicomSeg, core::ExportFormat::DicomSegLabelMap}) {
        core::ExportRequest request = on.request(format);
        request.seg.codes[1].modifier = sct("12345678901234567", "Too long");
        const auto report = core::exportMask(on.volume, request, {});
        QVERIFY(!report);
        QCOMPARE(report.error().code, core::ErrorCode::InvalidField);
        QVERIFY(!QFile::exists(on.file));
    }
}

void ExportSegTypesTest::aByteThatIsWrongIsFound_data()
{
    deflated_data();
}

/// The check looks at every voxel: labels that say otherwise in one are enough.
void ExportSegTypesTest::aByteThatIsWrongIsFound()
{
    QFETCH(core::ExportFormat, format);
    Made on;
    core::ExportRequest request = on.request(format);
    request.coverages = {
        {.label = 1, .layer = QStringLiteral("Sculpt 1"), .coverage = on.coverage}};
    QVERIFY(core::exportMask(on.volume, request, {}));
    const core::ExportExpectation right{.volume = on.volume,
        .segments = request.segments,
        .planes = request.planes,
        .format = format,
        .coverages = request.coverages};
    QVERIFY(core::checkSegExport(on.file, right, {}));
    const std::size_t voxel = 2 * on.area + 13;
    on.labels[voxel] = on.labels[voxel] == 2 ? 0 : 2;
    const auto checked = core::checkSegExport(on.file, right, {});
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, core::ErrorCode::ExportMismatch);
    QVERIFY(checked.error().arguments.value(1).contains(QStringLiteral("voxels are not as drawn")));
}

BURIN_TEST(ExportSegTypesTest)

} // namespace exportSegTypesTest

#include "ExportSegTypesTest.moc"
