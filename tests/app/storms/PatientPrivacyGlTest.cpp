// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/MarkedSeries.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace patientPrivacyGlTest {

using test::burin;
using test::key;
using test::Outcome;

namespace {

/// Names of the exports and their formats.
const std::initializer_list<std::pair<const char*, const char*>> formats{{"a.dcm", "dicom-seg"},
    {"b.dcm", "dicom-seg-fractional"}, {"c.dcm", "dicom-seg-labelmap"}, {"d.dcm", "rtstruct"},
    {"e.nii.gz", "nifti"}, {"f.seg.nrrd", "seg-nrrd"}, {"g.obj", "obj"}, {"h.csv", "csv"},
    {"i.json", "json"}, {"j.dcm", "sr"}};

QJsonObject recipe(const QTemporaryDir& folder)
{
    QJsonArray exports;
    for (const auto& [file, format] : formats)
        exports.append(QJsonObject{{key("format"), key(format)},
            {key("file"), folder.filePath(QLatin1String(file))}, {key("deidentify"), true}});
    const QJsonArray code{key("SCT"), key("10200004"), key("Liver")};
    const QJsonArray edits{
        QJsonObject{{key("edit"), key("addSegment")}, {key("name"), key("Leber")},
            {key("color"), key("#336699")}, {key("code"), code}},
        QJsonObject{{key("edit"), key("drill")},
            {key("view"),
                QJsonObject{{key("eyeLps"), QJsonArray{0, -300, 45}},
                    {key("targetLps"), QJsonArray{0, 0, 45}}, {key("up"), QJsonArray{0, 0, 1}},
                    {key("heightMm"), 60}, {key("orthographic"), true}}},
            {key("mask"), QJsonObject{{key("shape"), key("circle")}, {key("radiusMm"), 4}}},
            {key("depthMm"), 6}, {key("surface"), QJsonObject{{key("threshold"), -2000}}},
            {key("samples"), QJsonArray{QJsonValue(QJsonArray{0, 0, 1.0, 0.0})}}},
        QJsonObject{{key("edit"), key("layerToSegment")}, {key("layer"), 1}, {key("segment"), 1}}};
    return {{key("edits"), edits}, {key("export"), exports}};
}

/// The same voxels, of somebody else.
test::SyntheticSeries ofSomebodyElse()
{
    test::SyntheticSeries series = test::markedSeries();
    series.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_PatientName, "Other^One");
        set.putAndInsertString(DCM_SOPInstanceUID, ("2.25.4700099" + std::to_string(k)).c_str());
        set.putAndInsertString(DCM_FrameOfReferenceUID, "2.25.4700098");
    };
    return series;
}

} // namespace

/// Where a patient's name has no business: what the program says, pictures in sessions,
/// de-identified exports of `burin run`.
class PatientPrivacyGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void nothingTellsWhoThePatientIs()
    {
        const QTemporaryDir studies;
        const QTemporaryDir out;
        const QString study = studies.filePath(QStringLiteral("one"));
        test::writeSeries(test::markedSeries(), study);
        const Outcome made = burin({key("run"),
            CommandFixture::recipe("r.json", patientPrivacyGlTest::recipe(out)), key("--study"),
            study, key("--session"), path("a.burin"), key("--trace"), path("trace.json")});
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        QVERIFY(QFile::exists(path("trace.json")));
        QVERIFY2(test::markersIn(path("trace.json")).isEmpty(),
            test::markersIn(path("trace.json")).join(' ').constData());
        for (const QByteArray& marker : test::markers()) {
            QVERIFY2(!made.output.contains(marker), made.output.constData());
            QVERIFY2(
                !made.complaint.contains(QString::fromLatin1(marker)), qPrintable(made.complaint));
        }
        const QFileInfoList files = QDir(out.path()).entryInfoList(QDir::Files | QDir::Hidden);
        QCOMPARE(std::size_t(files.size()), formats.size() + 1);
        for (const QFileInfo& file : files) {
            const QByteArrayList found = test::markersIn(file.filePath());
            QVERIFY2(found.isEmpty(), (file.fileName().toUtf8() + found.join(' ')).constData());
        }

        const Outcome taken = burin({key("history"), path("a.burin"), key("--deidentified"),
            path("b.burin"), key("--dates"), key("-10")});
        QVERIFY2(taken.status == 0, qPrintable(taken.complaint));
        QVERIFY2(test::markersIn(path("b.burin")).isEmpty(),
            test::markersIn(path("b.burin")).join(' ').constData());
        const Outcome verified =
            burin({key("replay"), path("b.burin"), key("--verify"), key("--study"), study});
        QVERIFY2(verified.status == 0, qPrintable(verified.complaint));
    }

    /// A session that holds the study's images, and with them who the patient is: of that nothing
    /// is in its copy for others.
    void imagesAreLeftOutOfACopyForOthers()
    {
        const QTemporaryDir studies;
        const QTemporaryDir out;
        const QString study = studies.filePath(QStringLiteral("one"));
        test::writeSeries(test::markedSeries(), study);
        QJsonObject content = patientPrivacyGlTest::recipe(out);
        content.remove(key("export"));
        const Outcome made = burin({key("run"), CommandFixture::recipe("r.json", content),
            key("--study"), study, key("--session"), path("i.burin"), key("--with-images")});
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        const auto count = [this](const char* session, const char* what) {
            return test::text(path(session), QLatin1String(what)).toInt();
        };
        constexpr const char* pieces = "SELECT COUNT(*) FROM pixels";
        constexpr const char* headers = "SELECT COUNT(headers) + COUNT(images) FROM source";
        QVERIFY(count("i.burin", pieces) > 0 && count("i.burin", headers) == 2);
        const Outcome taken =
            burin({key("history"), path("i.burin"), key("--deidentified"), path("d.burin")});
        QVERIFY2(taken.status == 0, qPrintable(taken.complaint));
        QCOMPARE(count("d.burin", pieces), 0);
        QCOMPARE(count("d.burin", headers), 0);
        // Pages that are free among them.
        QVERIFY2(test::markersIn(path("d.burin")).isEmpty(),
            test::markersIn(path("d.burin")).join(' ').constData());
        const Outcome verified =
            burin({key("replay"), path("d.burin"), key("--verify"), key("--study"), study});
        QVERIFY2(verified.status == 0, qPrintable(verified.complaint));
    }

    /// A state of the history, exported later.
    void replayTakesThePatientOut()
    {
        const QTemporaryDir studies;
        const QTemporaryDir out;
        const QString study = studies.filePath(QStringLiteral("one"));
        test::writeSeries(test::markedSeries(), study);
        QJsonObject content = patientPrivacyGlTest::recipe(out);
        content.remove(key("export"));
        const Outcome made = burin({key("run"), CommandFixture::recipe("r.json", content),
            key("--study"), study, key("--session"), path("a.burin")});
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        const auto replayed = [&](const char* file, const QStringList& more) {
            return burin(QStringList{key("replay"), path("a.burin"), key("--export"),
                             out.filePath(QLatin1String(file)), key("--study"), study}
                + more);
        };
        const QStringList both{key("--deidentify"), key("--deflated")};
        const Outcome plain = replayed("plain.dcm", {});
        QVERIFY2(plain.status == 0, qPrintable(plain.complaint));
        QVERIFY(!test::markersIn(out.filePath(QStringLiteral("plain.dcm"))).isEmpty());
        const Outcome taken = replayed("seg.dcm", both);
        QVERIFY2(taken.status == 0, qPrintable(taken.complaint));
        const QByteArrayList found = test::markersIn(out.filePath(QStringLiteral("seg.dcm")));
        QVERIFY2(found.isEmpty(), found.join(' ').constData());
        DcmFileFormat file;
        QVERIFY(file.loadFile(out.filePath(QStringLiteral("seg.dcm")).toUtf8().constData()).good());
        OFString syntax;
        QVERIFY(file.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, syntax).good());
        QCOMPARE(syntax.c_str(), UID_DeflatedExplicitVRLittleEndianTransferSyntax);
        // What a format does not know is refused by its option's name.
        const Outcome refused = replayed("map.nii.gz", both);
        QCOMPARE(refused.status, 2);
        QVERIFY2(refused.complaint.contains(key("--deflated")), qPrintable(refused.complaint));
    }

    /// The pictures that a session shows itself by are those of voxels alone.
    void picturesInSessionsNameNobody()
    {
        const QTemporaryDir studies;
        const QTemporaryDir out;
        QByteArrayList pictures;
        int i = 0;
        for (const test::SyntheticSeries& series : {test::markedSeries(), ofSomebodyElse()}) {
            const QString study = studies.filePath(QString::number(i));
            const QByteArray session = QByteArray::number(i++) + ".burin";
            test::writeSeries(series, study);
            QJsonObject content = patientPrivacyGlTest::recipe(out);
            content.remove(key("export"));
            const Outcome made = burin({key("run"), CommandFixture::recipe("p.json", content),
                key("--study"), study, key("--session"), path(session.constData())});
            QVERIFY2(made.status == 0, qPrintable(made.complaint));
            pictures += test::text(path(session.constData()),
                QStringLiteral("SELECT group_concat(hex(png)) FROM keyframe"))
                            .toLatin1();
        }
        QVERIFY(pictures[0].size() > 1000);
        QVERIFY(pictures[0] == pictures[1]);
    }
};

BURIN_TEST(PatientPrivacyGlTest)

} // namespace patientPrivacyGlTest

#include "PatientPrivacyGlTest.moc"
