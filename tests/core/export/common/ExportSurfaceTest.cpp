// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckExport.h"
#include "core/masks/MaskOnVolume.h"
#include "core/meshfile/MeshReader.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/Affine.h"
#include "tests/support/series/LabelledSeries.h"
#include "tests/support/servers/Python.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <functional>
#include <random>

namespace exportSurfaceTest {

namespace {

using Format = core::ExportFormat;
using Alter = std::function<void(QByteArray&)>;

const std::array<std::pair<Format, const char*>, 4> formats{std::pair(Format::Stl, "a.stl"),
    std::pair(Format::Obj, "a.obj"), std::pair(Format::Ply, "a.ply"),
    std::pair(Format::Gltf, "a.glb")};

core::Segment segmentOf(int label, const QString& name)
{
    core::Segment segment;
    segment.label = std::uint8_t(label);
    segment.name = name;
    segment.rgb = 0x3399ffU + unsigned(label);
    return segment;
}

QString messageOf(const core::Error& error)
{
    return error.arguments.join(QStringLiteral(" | "));
}

test::SmallSeries axialSeries()
{
    return test::placementOf(QStringLiteral("axial")).series;
}

std::vector<std::uint8_t> randomLabels(const glm::ivec3& size)
{
    std::mt19937 random(4);
    std::vector<std::uint8_t> labels(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (auto& label : labels)
        label = std::uint8_t(random() % 4);
    return labels;
}

struct Fixture : test::LabelledSeries {
    explicit Fixture(const test::SmallSeries& series = axialSeries())
        : LabelledSeries(series, randomLabels(series.size))
    {
    }
    [[nodiscard]] QString file(const char* name) const
    {
        return folder.filePath(QLatin1String(name));
    }
    [[nodiscard]] core::Result<core::ExportReport> exported(
        Format format, const char* name, core::MeshSpace space = core::MeshSpace::Lps) const
    {
        return core::exportMask(volume,
            {.format = format,
                .file = file(name),
                .force = true,
                .segments = segments,
                .planes = planes,
                .space = space},
            {});
    }
    [[nodiscard]] core::Result<core::ReportLines> checked(
        Format format, const char* name, core::MeshSpace space = core::MeshSpace::Lps) const
    {
        return core::checkSurfaceExport(format, file(name), {volume, segments, planes, space}, {});
    }

    std::vector<core::Segment> segments{
        segmentOf(1, QStringLiteral("Schädel")), segmentOf(3, QStringLiteral("Leber rechts"))};
};

core::Result<core::ReadMesh> readAs(Format format, const QString& file)
{
    switch (format) {
    case Format::Obj:
        return core::readObj(file);
    case Format::Ply:
        return core::readPly(file);
    case Format::Gltf:
        return core::readGltf(file);
    default:
        return core::readStl(file);
    }
}

} // namespace

} // namespace exportSurfaceTest

Q_DECLARE_METATYPE(exportSurfaceTest::Alter)

namespace exportSurfaceTest {

/// Surfaces as STL, OBJ, PLY and glTF.
class ExportSurfaceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyGeometry_data() { test::addPlacementRows(); }
    void everyGeometry();
    void readByOthers_data();
    void readByOthers();
    void rasIsHalfATurn();
    void namesOfAnyKind();
    void noMillilitresOfUnknownVoxels();
    void fullDiskLeavesNothing();
    void faultInTheFileIsCaught_data();
    void faultInTheFileIsCaught();
};

void ExportSurfaceTest::everyGeometry()
{
    QFETCH(QString, placement);
    const Fixture on(test::placementOf(placement).series);
    for (const auto& [format, name] : formats) {
        const auto report = on.exported(format, name);
        QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
        QCOMPARE(report->checked.size(), 2);
        const auto mesh = readAs(format, on.file(name));
        QVERIFY(mesh.has_value());
        QCOMPARE(mesh->space, QStringLiteral("LPS"));
        QCOMPARE(mesh->parts.size(), std::size_t(format == Format::Stl ? 1 : 2));
        // Taken in again it is the same voxels.
        const auto mask = core::readMask(on.file(name), on.volume, {});
        QVERIFY2(mask.has_value(), qPrintable(mask ? QString() : messageOf(mask.error())));
        std::vector<std::uint8_t> again(on.labels.size(), 0);
        for (std::size_t i = 0; i < mask->segments.size(); ++i) {
            for (const core::VoxelRun& run : mask->segments[i].voxels.runs())
                std::fill_n(
                    again.begin() + std::ptrdiff_t(run.first), run.count, on.segments[i].label);
        }
        for (std::size_t i = 0; i < again.size(); ++i) {
            const bool isDrawn = on.labels[i] == 1 || on.labels[i] == 3;
            const int expected = format == Format::Stl ? 1 : on.labels[i];
            QCOMPARE(int(again[i]), isDrawn ? expected : 0);
        }
        if (format == Format::Stl)
            continue;
        QCOMPARE(mesh->parts[0].name, QStringLiteral("Schädel"));
        QCOMPARE(mesh->parts[1].name, QStringLiteral("Leber rechts"));
        QCOMPARE(mesh->parts[1].rgb.value_or(0), 0x339a02U);
    }
}

/// The same points, seen from the other axes, on a grid that is turned and tilted; with BURIN_LONG
/// however the series lies.
void ExportSurfaceTest::readByOthers_data()
{
    QTest::addColumn<Format>("format");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<bool>("ras");
    QTest::addColumn<QString>("placement");
    const QString turned = QStringLiteral("oblique and tilted");
    for (const auto& [format, name] : formats) {
        for (const test::SeriesPlacement& lies : test::seriesPlacements()) {
            const QString placement = QString::fromLatin1(lies.name);
            if (placement != turned && !test::longRun())
                continue;
            QTest::addRow("%s LPS, %s", name, lies.name)
                << format << QByteArray(name) << false << placement;
            QTest::addRow("%s RAS, %s", name, lies.name)
                << format << QByteArray(name) << true << placement;
        }
    }
}

/// A reader in Python that knows the formats and nothing of Burin finds the same voxels inside.
void ExportSurfaceTest::readByOthers()
{
    QFETCH(Format, format);
    QFETCH(QByteArray, name);
    QFETCH(bool, ras);
    QFETCH(QString, placement);
    const Fixture on(test::placementOf(placement).series);
    const auto report =
        on.exported(format, name.constData(), ras ? core::MeshSpace::Ras : core::MeshSpace::Lps);
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));

    QFile places(on.file("places.txt"));
    QVERIFY(places.open(QIODevice::WriteOnly));
    QByteArray expected;
    std::size_t at = 0;
    for (int z = 0; z < on.volume.geometry.size.z; ++z) {
        for (int y = 0; y < on.volume.geometry.size.y; ++y) {
            for (int x = 0; x < on.volume.geometry.size.x; ++x, ++at) {
                const glm::dvec3 place = test::placeOf(on.volume.geometry, {x, y, z});
                places.write(QStringLiteral("%1 %2 %3\n")
                                 .arg(place.x, 0, 'g', 17)
                                 .arg(place.y, 0, 'g', 17)
                                 .arg(place.z, 0, 'g', 17)
                                 .toLatin1());
                expected += on.labels[at] == 1 || on.labels[at] == 3 ? '1' : '0';
            }
        }
    }
    places.close();
    const auto read = test::runScript(QStringLiteral("surface_inside.py"),
        {on.file(name.constData()), places.fileName(),
            ras ? QStringLiteral("RAS") : QStringLiteral("LPS")});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    QCOMPARE(read.output.trimmed(), expected);
}

void ExportSurfaceTest::rasIsHalfATurn()
{
    const Fixture on;
    for (const auto& [format, name] : formats) {
        QVERIFY(on.exported(format, name));
        const auto lps = readAs(format, on.file(name));
        QVERIFY(on.exported(format, name, core::MeshSpace::Ras));
        const auto ras = readAs(format, on.file(name));
        QVERIFY(lps && ras);
        QCOMPARE(ras->space, QStringLiteral("RAS"));
        QVERIFY(!on.checked(format, name, core::MeshSpace::Lps));
        QCOMPARE(ras->parts[0].triangles.size(), lps->parts[0].triangles.size());
        for (std::size_t i = 0; i < lps->parts[0].vertices.size(); ++i)
            QVERIFY(ras->parts[0].vertices[i] * glm::vec3(-1, -1, 1) == lps->parts[0].vertices[i]);
    }
}

/// Where the study does not say how large its voxels are, nobody has measured them.
void ExportSurfaceTest::noMillilitresOfUnknownVoxels()
{
    Fixture on;
    for (const bool isKnown : {true, false}) {
        if (!isKnown)
            on.volume.problems.push_back({.kind = core::VolumeProblem::Kind::AssumedSpacing,
                .said = {core::ProblemCode::SpacingAssumed}});
        const auto report = on.exported(Format::Ply, "a.ply");
        QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
        const auto& said = std::get<core::ReportSentence>(report->written.front());
        QVERIFY(said.code == core::ReportCode::Surfaces);
        const auto& surfaces = std::get<core::ReportSentence::Listed>(said.arguments.at(2));
        QCOMPARE(surfaces.all.size(), std::size_t(2));
        for (const core::ReportSentence& each : surfaces.all)
            QVERIFY(each.code
                == (isKnown ? core::ReportCode::SurfaceOf : core::ReportCode::TrianglesOf));
    }
}

void ExportSurfaceTest::namesOfAnyKind()
{
    Fixture on;
    on.segments[0].name = QStringLiteral("頭蓋 \"a\": b\n\tc \\ ");
    on.segments[1].name.clear();
    for (const auto& [format, name] : formats) {
        const auto report = on.exported(format, name);
        QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
        const auto mesh = readAs(format, on.file(name));
        if (format == Format::Stl)
            continue;
        QCOMPARE(mesh->parts[0].name, QStringLiteral("頭蓋 \"a\": b c \\"));
        QCOMPARE(mesh->parts[1].name, QStringLiteral("Segment"));
    }
}

void ExportSurfaceTest::fullDiskLeavesNothing()
{
    const Fixture on;
    const test::FileSizeLimit limit(5000);
    for (const auto& [format, name] : formats) {
        const auto report = on.exported(format, name);
        QVERIFY(!report);
        QCOMPARE(report.error().code, core::ErrorCode::FileUnwritable);
        QCOMPARE(report.error().arguments.value(0), on.file(name));
    }
    QVERIFY(QDir(on.folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
}

void ExportSurfaceTest::faultInTheFileIsCaught_data()
{
    QTest::addColumn<int>("format");
    QTest::addColumn<Alter>("change");
    const auto row = [](const char* name, Format format, const Alter& change) {
        QTest::newRow(name) << int(format) << change;
    };
    const auto word = [](const char* from, const char* to) {
        return Alter([=](QByteArray& bytes) {
            QVERIFY(bytes.contains(from));
            bytes.replace(bytes.indexOf(from), qsizetype(qstrlen(from)), to);
        });
    };
    row("STL: other axes", Format::Stl, word("SPACE=LPS", "SPACE=RAS"));
    row("STL: a triangle turned", Format::Stl, [](QByteArray& bytes) {
        const QByteArray first = bytes.mid(84 + 12, 12);
        bytes.replace(84 + 12, 12, bytes.mid(84 + 24, 12));
        bytes.replace(84 + 24, 12, first);
    });
    row("STL: a triangle less", Format::Stl, [](QByteArray& bytes) {
        bytes.chop(50);
        std::uint32_t count = 0;
        std::memcpy(&count, bytes.constData() + 80, 4);
        --count;
        std::memcpy(bytes.data() + 80, &count, 4);
    });
    row("STL: everything inside out", Format::Stl, [](QByteArray& bytes) {
        for (qsizetype at = 84; at < bytes.size(); at += 50) {
            const QByteArray first = bytes.mid(at + 12, 12);
            bytes.replace(at + 12, 12, bytes.mid(at + 24, 12));
            bytes.replace(at + 24, 12, first);
        }
    });
    row("STL: a column off", Format::Stl, [](QByteArray& bytes) {
        for (qsizetype at = 84; at < bytes.size(); at += 50) {
            for (qsizetype corner = 12; corner < 48; corner += 12) {
                float x = 0.0F;
                std::memcpy(&x, bytes.constData() + at + corner, 4);
                x += 0.7F;
                std::memcpy(bytes.data() + at + corner, &x, 4);
            }
        }
    });
    row("OBJ: another name", Format::Obj, word("o Leber", "o Niere"));
    row("OBJ: one face less", Format::Obj, [](QByteArray& bytes) {
        const qsizetype at = bytes.indexOf("\nf ");
        bytes.remove(at, bytes.indexOf('\n', at + 1) - at);
    });
    row("OBJ: segments exchanged", Format::Obj, [](QByteArray& bytes) {
        bytes.replace("o Leber rechts", "o X");
        bytes.replace("o Sch\xc3\xa4"
                      "del",
            "o Leber rechts");
        bytes.replace("o X",
            "o Sch\xc3\xa4"
            "del");
    });
    row("PLY: another label", Format::Ply, word("comment segment 1", "comment segment 2"));
    row("PLY: another name", Format::Ply, word(": Leber", ": Niere"));
    row("PLY: other axes", Format::Ply, word("SPACE=LPS", "SPACE=RAS"));
    row("glTF: another name", Format::Gltf,
        [](QByteArray& bytes) { bytes.replace("Leber rechts", "Niere rechts"); });
    row("glTF: other axes", Format::Gltf, word("\"space\":\"LPS\"", "\"space\":\"RAS\""));
    row("glTF: does not stand upright", Format::Gltf,
        word("\"matrix\":[0.001", "\"matrix\":[0.002"));
}

void ExportSurfaceTest::faultInTheFileIsCaught()
{
    QFETCH(int, format);
    QFETCH(Alter, change);
    const Fixture on;
    const auto as = Format(format);
    const char* name = nullptr;
    for (const auto& [known, file] : formats)
        name = known == as ? file : name;
    QVERIFY(on.exported(as, name));
    QVERIFY(on.checked(as, name));
    QFile opened(on.file(name));
    QVERIFY(opened.open(QIODevice::ReadWrite));
    QByteArray bytes = opened.readAll();
    const QByteArray before = bytes;
    change(bytes);
    QVERIFY(bytes != before);
    QVERIFY(opened.resize(0) && opened.seek(0) && opened.write(bytes) == bytes.size());
    opened.close();
    const auto checked = on.checked(as, name);
    QVERIFY(!checked);
    QCOMPARE(checked.error().arguments.value(0), on.file(name));
}

BURIN_TEST(ExportSurfaceTest)

} // namespace exportSurfaceTest

#include "ExportSurfaceTest.moc"
