// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/BookmarkMenu.h"

#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QTimer>
#include <QtTest>

namespace bookmarksUiTest {

namespace {

struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(test::smallStudy())
        , view(window.views().volume())
    {
        window.bookmarks().fill(menu);
    }
    /// What the menu offers when it opens.
    [[nodiscard]] QStringList offered()
    {
        Q_EMIT menu.aboutToShow();
        QStringList texts;
        for (const QAction* action : menu.actions()) {
            if (!action->isSeparator())
                texts += action->text();
        }
        return texts;
    }
    void choose(QMenu& from, const QString& text)
    {
        for (QAction* action : from.actions()) {
            if (action->text() == text)
                return action->trigger();
        }
        QFAIL(qPrintable(text));
    }

    ui::VolumeView& view;
    QMenu menu;
};

double apart(const ui::Camera& a, const ui::Camera& b)
{
    return glm::distance(a.targetLps, b.targetLps)
        + 100.0 * glm::distance(a.towardsViewer, b.towardsViewer)
        + 100.0 * glm::distance(a.up, b.up) + std::abs(a.heightMm - b.heightMm);
}

} // namespace

class BookmarksUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void bringsCameraAndCrosshairBack()
    {
        Fixture fixture;
        QCOMPARE(fixture.offered().size(), 1);
        QVERIFY(!fixture.menu.actions().front()->isEnabled());

        ui::Camera camera = fixture.view.camera();
        camera.orbit(33.3, -12.7);
        camera.pan(3.14, -2.71);
        camera.heightMm *= 0.77;
        fixture.view.setCamera(camera);
        fixture.workspace.setCrosshairLps({4.125, -3.25, 2.0});
        fixture.window.bookmarks().keep(QStringLiteral("Orbit & from the left"));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().back().name,
            QStringLiteral("Bookmark 'Orbit & from the left'"));

        fixture.view.lookFrom({0.0, 0.0, 1.0});
        fixture.view.resetView();
        fixture.workspace.setCrosshairLps({0.0, 0.0, 0.0});
        const std::size_t rows = fixture.session().history().rows().size();
        QCOMPARE(fixture.offered().front(), QStringLiteral("Orbit && from the left"));
        fixture.choose(fixture.menu, QStringLiteral("Orbit && from the left"));
        QVERIFY2(apart(fixture.view.camera(), camera) < 0.01,
            qPrintable(QString::number(apart(fixture.view.camera(), camera))));
        QCOMPARE(std::abs(glm::dot(fixture.view.camera().up, fixture.view.camera().towardsViewer))
                < 1e-12,
            true);
        QVERIFY(fixture.workspace.crosshairLps() == glm::dvec3(4.125, -3.25, 2.0));
        QCOMPARE(fixture.session().history().rows().size(), rows); // no step
    }

    void isTakenBackAndRemoved()
    {
        Fixture fixture;
        for (const char* name : {"One", "Two"})
            fixture.window.bookmarks().keep(QLatin1String(name));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.offered(),
            (QStringList{QStringLiteral("One"), QStringLiteral("Two"), QStringLiteral("Remove")}));
        QMenu* remove = fixture.menu.actions().back()->menu();
        QVERIFY(remove);
        fixture.choose(*remove, QStringLiteral("One"));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.offered().front(), QStringLiteral("Two"));
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.offered().size(), 3);
        QCOMPARE(fixture.offered().front(), QStringLiteral("One"));
    }

    void asksForAName_data()
    {
        QTest::addColumn<bool>("accepted");
        QTest::addColumn<QString>("name");
        QTest::newRow("as it is offered") << true << QStringLiteral("View 1");
        QTest::newRow("named") << true << QStringLiteral("Orbit");
        QTest::newRow("not at all") << false << QStringLiteral("Orbit");
    }
    void asksForAName()
    {
        QFETCH(bool, accepted);
        QFETCH(QString, name);
        Fixture fixture;
        QTimer::singleShot(0, &fixture.window, [&fixture, accepted, name] {
            auto* dialog = fixture.window.findChild<QInputDialog*>();
            QVERIFY(dialog);
            QCOMPARE(dialog->textValue(), QStringLiteral("View 1"));
            dialog->setTextValue(name);
            accepted ? dialog->accept() : dialog->reject();
        });
        fixture.window.actionTable()[QStringLiteral("view.bookmark")].trigger();
        QVERIFY(fixture.session().settle());
        const auto& bookmarks = fixture.session().document().bookmarks;
        QCOMPARE(bookmarks.size(), std::size_t(accepted ? 1 : 0));
        if (accepted)
            QCOMPARE(bookmarks.front().name, name);
    }
};

BURIN_WINDOW_TEST(BookmarksUiTest)

} // namespace bookmarksUiTest

#include "BookmarksUiTest.moc"
