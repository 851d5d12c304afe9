// SPDX-License-Identifier: Apache-2.0
#include "ui/report/AuditPages.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "ui/report/AuditHtml.h"
#include "ui/report/WriteAudit.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>

namespace auditPagesTest {

using namespace core;
using ui::AuditPages;
using ui::AuditTexts;

namespace {

using Standing = AuditStep::Standing;

const QSizeF a4(1240, 1754); // 150 dpi

QByteArray png(const QColor& colour)
{
    QImage image(256, 171, QImage::Format_RGB888);
    image.fill(colour);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

/// A report of @p count steps, of every kind there is.
AuditReport reportOf(int count)
{
    AuditReport report;
    report.file = QStringLiteral("case 7.burin");
    report.source = {.path = QStringLiteral("/data/Doe^Jane/ct"),
        .format = QStringLiteral("DICOM"),
        .studyUid =
            QStringLiteral("1.3.6.1.4.1.14519.5.2.1.6279.6001.298806137288633453246975630178"),
        .seriesUid =
            QStringLiteral("1.3.6.1.4.1.14519.5.2.1.6279.6001.179049373636438705059720603192"),
        .size = {512, 512, 600},
        .indexToWorld = glm::dmat4(0.78125, 0, 0, 0, 0, 0.78125, 0, 0, 0, 0, 0.625, 0, 0, 0, 0, 1),
        .voxelsSha256 = QByteArray(64, 'a')};
    report.chainEnd = QString(64, u'c');
    report.made = {.at = QDateTime({2026, 11, 21}, {15, 0, 0}, Qt::UTC),
        .author = {},
        .program = QStringLiteral("burin 0.1.0")};
    for (int i = 1; i <= count; ++i) {
        AuditStep step;
        step.row.id = i;
        step.row.parent = i - 1;
        step.row.name = i % 7 == 0
            ? QStringLiteral("Add segment 'A rather long name of a structure, with <b>markup</b> & "
                             "an unbrokenwordthatislongerthanthewholecolumnwilleverbe'")
            : QStringLiteral("Grow 'Left ventricle' 41 steps, +18 204 voxels");
        step.row.origin = {.at = QDateTime({2026, 11, 21}, {14, 2, 3, 45}, Qt::UTC).addSecs(i * 9),
            .author = i % 3 ? QStringLiteral("Dr. Jörg Müller") : QString(),
            .program = QStringLiteral("burin 0.1.0")};
        step.row.statistics.voxelsChanged = 18204;
        step.row.deltaBytes = 7300;
        step.row.stateHash =
            QCryptographicHash::hash(QByteArray::number(i), QCryptographicHash::Sha256).toHex();
        step.standing = Standing(i % 4);
        step.takenBackBy = step.standing == Standing::TakenBack ? i + 1 : 0;
        report.steps.push_back(step);
    }
    report.branches = {{.tip = RowId(count), .forksAt = 0, .rows = {1}, .current = true},
        {.tip = 3, .forksAt = 2, .rows = {3}, .current = false}};
    report.sealed = count;
    for (int i = 1; i <= count; i += 10)
        report.keyframes.push_back(
            {.row = i, .at = report.made.at, .png = png(QColor(200, i % 255, 90))});
    return report;
}

bool isBlank(const QImage& image, const QRectF& box)
{
    for (int y = int(box.top()); y < int(box.bottom()); ++y) {
        for (int x = int(box.left()); x < int(box.right()); ++x) {
            if (image.pixelColor(x, y).lightness() < 180)
                return false;
        }
    }
    return true;
}

QImage painted(const AuditPages& pages, int page)
{
    QImage image(a4.toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    pages.paint(painter, page);
    return image;
}

} // namespace

class AuditPagesTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Every row is on one page, below the one before it, and painted where it says.
    void noRowIsCut_data()
    {
        QTest::addColumn<int>("steps");
        for (const int steps : {1, 9, 10, 11, 12, 13, 200})
            QTest::addRow("%d", steps) << steps;
        if (qEnvironmentVariableIsSet("BURIN_LONG"))
            QTest::addRow("%d", 10000) << 10000;
    }
    void noRowIsCut()
    {
        QFETCH(int, steps);
        const AuditPages pages(AuditTexts::of(reportOf(steps)), a4);
        const auto places = pages.stepPlaces();
        QCOMPARE(int(places.size()), steps);
        const QRectF box = pages.contentBox();
        int page = 0;
        double free = box.top();
        for (const AuditPages::Place& place : places) {
            QVERIFY(place.page == page || place.page == page + 1);
            if (place.page != page)
                free = box.top();
            page = place.page;
            QVERIFY(place.box.top() >= free);
            QVERIFY(place.box.bottom() <= box.bottom());
            QVERIFY(place.page < pages.count());
            free = place.box.bottom();
        }
        for (int i = 0; i < pages.count(); ++i) {
            const QImage image = painted(pages, i);
            const QRectF below(0, box.bottom() + 2, a4.width(), 10);
            QVERIFY2(isBlank(image, below), qPrintable(QStringLiteral("page %1").arg(i)));
            QVERIFY(!isBlank(image, {0, 0, a4.width(), box.top()})); // header
            QVERIFY(!isBlank(image, {0, below.bottom(), a4.width(), a4.height() - below.bottom()}));
            for (const AuditPages::Place& place : places)
                QVERIFY(place.page != i || !isBlank(image, place.box));
        }
        if (qEnvironmentVariableIsSet("BURIN_SCREENSHOTS")) {
            const QDir folder(qEnvironmentVariable("BURIN_SCREENSHOTS"));
            for (int i = 0; i < pages.count(); ++i)
                painted(pages, i).save(
                    folder.filePath(QStringLiteral("audit-%1-page%2.png").arg(steps).arg(i + 1)));
        }
    }

    void anEndlessNameFitsOnAPage()
    {
        AuditReport report = reportOf(30);
        report.steps[4].row.name = QString(100000, u'n');
        report.steps[5].row.origin.author = QString(3000, u'w');
        const AuditPages pages(AuditTexts::of(report), a4);
        for (const AuditPages::Place& place : pages.stepPlaces())
            QVERIFY(pages.contentBox().contains(place.box));
    }

    /// It stands behind all that is said of a history in any case.
    void whatIsDamagedStandsOnPaper()
    {
        const auto pageSaying = [](const QString& reason) {
            AuditReport report = reportOf(2);
            report.damage = {
                {ErrorCode::SessionDamaged, {QStringLiteral("/home/me/a.burin"), reason}}};
            return painted(AuditPages(AuditTexts::of(report), a4), 0);
        };
        const QString begin = QStringLiteral("the file ends in the middle of what it says of row ");
        QVERIFY(pageSaying(begin + u'1') == pageSaying(begin + u'1'));
        QVERIFY(pageSaying(begin + u'1') != pageSaying(begin + u'2'));
    }

    /// However much is damaged, nothing is painted over the foot of a page.
    void endlessDamageFitsOnAPage()
    {
        AuditReport report = reportOf(1);
        report.damage = {{ErrorCode::SessionDamaged,
            {QStringLiteral("/home/me/a.burin"), QString(20000, u'W')}}};
        const AuditPages pages(AuditTexts::of(report), a4);
        for (int page = 0; page < pages.count(); ++page)
            QVERIFY(isBlank(
                painted(pages, page), {0, pages.contentBox().bottom() + 2, a4.width(), 10}));
    }

    void whatWasNotDoneIsSaid()
    {
        const AuditTexts nothing = AuditTexts::of(reportOf(0));
        QVERIFY(nothing.steps.empty() && !nothing.noSteps.isEmpty());
        QVERIFY(nothing.pictures.empty() && !nothing.noPictures.isEmpty());
        QCOMPARE(AuditPages(nothing, a4).count(), 1);

        AuditReport report = reportOf(4);
        const AuditTexts texts = AuditTexts::of(report);
        QCOMPARE(texts.steps[0].note, QStringLiteral("taken back by step 2"));
        QCOMPARE(texts.steps[1].note, QStringLiteral("undone"));
        QCOMPARE(texts.steps[2].note, QStringLiteral("old future, behind step 2"));
        QCOMPARE(texts.steps[3].note, QString());
        QVERIFY(texts.steps[3].stands && !texts.steps[0].stands);
        QCOMPARE(texts.steps[0].when, QStringLiteral("2026-11-21 14:02:12"));
        QCOMPARE(texts.steps[2].who, QStringLiteral("—"));
        QVERIFY(texts.sound);

        report.damage = {{ErrorCode::SessionDamaged,
            {QStringLiteral("/home/Doe^Jane/a.burin"), QStringLiteral("row 3: gone")}}};
        report.sealed = 3;
        const AuditTexts damaged = AuditTexts::of(report);
        QVERIFY(!damaged.sound);
        QVERIFY(damaged.explanation.contains(QStringLiteral("row 3: gone")));
        QVERIFY(!damaged.explanation.contains(QStringLiteral("Jane")));
        report.damage.clear();
        report.steps.back().row.stateHash.clear();
        QVERIFY(AuditTexts::of(report).explanation.contains(QStringLiteral("not finished")));

        report.steps.front().row.origin = {};
        QCOMPARE(AuditTexts::of(report).steps[0].when, QStringLiteral("not recorded"));
    }

    void theHtmlHoldsAllAndNoPatient()
    {
        const AuditReport report = reportOf(25);
        const QString html = auditHtml(AuditTexts::of(report)).replace(QChar::Nbsp, u' ');
        for (const AuditStep& step : report.steps) {
            QVERIFY(html.contains(step.row.name.toHtmlEscaped()));
            QVERIFY(html.contains(QString::fromLatin1(step.row.stateHash.left(10))));
        }
        for (const Keyframe& keyframe : report.keyframes) {
            QVERIFY(html.contains(QString::fromLatin1(keyframe.png.toBase64())));
            const auto hash = QCryptographicHash::hash(keyframe.png, QCryptographicHash::Sha256);
            QVERIFY(html.contains(QString::fromLatin1(hash.toHex())));
        }
        for (const QString& text : {report.source.seriesUid, report.source.studyUid,
                 report.chainEnd, QString::fromLatin1(report.source.voxelsSha256),
                 QStringLiteral("512 × 512 × 600 voxels of 0.7813 × 0.7813 × 0.625 mm, DICOM")})
            QVERIFY2(html.contains(text), qPrintable(text));
        QVERIFY(!html.contains(QStringLiteral("<b>markup")));
        QVERIFY(!html.contains(QStringLiteral("Jane")));
        QVERIFY(html.contains(QStringLiteral("@page"))); // its style is in it
    }

    void filesAreWrittenWholeOrNotAtAll()
    {
        const AuditReport report = reportOf(40);
        const auto path = [this](
                              const char* name) { return m_folder.filePath(QLatin1String(name)); };
        for (const char* name : {"a.html", "b.PDF"}) {
            QVERIFY(ui::writeAudit(report, path(name), false));
            QCOMPARE(ui::writeAudit(report, path(name), false).error().code, ErrorCode::FileExists);
            QVERIFY(ui::writeAudit(report, path(name), true));
        }
        QFile pdf(path("b.PDF"));
        QVERIFY(pdf.open(QIODevice::ReadOnly));
        const QByteArray content = pdf.readAll();
        QVERIFY(content.startsWith("%PDF-"));
        const int pages = AuditPages(AuditTexts::of(report), a4).count();
        QCOMPARE(int(content.count("/Type /Page\n")), pages);
        QVERIFY(pages > 2);

        const Result<void> nowhere = ui::writeAudit(report, path("no/such/c.pdf"), false);
        QCOMPARE(nowhere.error().code, ErrorCode::FileUnwritable);
        QCOMPARE(nowhere.error().arguments.value(0), path("no/such/c.pdf"));
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
        QVERIFY(!ui::auditNameProblem(path("c.docx")).isEmpty());
        QVERIFY(ui::auditNameProblem(path("c.htm")).isEmpty());
    }
};

namespace {

int runAuditPages(int argc, char** argv)
{
    // Fonts, but no display.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    return test::runTest<AuditPagesTest, QGuiApplication>(argc, argv);
}

} // namespace

BURIN_TEST_RUN(AuditPagesTest, runAuditPages)

} // namespace auditPagesTest

#include "AuditPagesTest.moc"
