// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/panels/history/StrokeRevision.h"

#include <QDialog>
#include <QWidget>
#include <QtTest>

#include <utility>

namespace strokeRevisionUiTest {

namespace {

struct RevisionFixture : test::WorkspaceFixture {
    RevisionFixture()
        : WorkspaceFixture(test::smallStudy())
        , revision(workspace, &window)
    {
    }
    void remove(core::RowId row)
    {
        revision.remove(row);
        settle();
    }
    void restore(core::RowId row)
    {
        revision.restore(row);
        settle();
    }
    void openTheNext()
    {
        workspace.setSession(nullptr);
        auto next = core::EditSession::create(engine, test::smallStudy(), {});
        if (!next)
            qFatal("the session could not be made");
        workspace.setSession(std::move(*next));
    }
    [[nodiscard]] core::ReviseStroke last()
    {
        return session().history().rows().back().edit.get<core::ReviseStroke>();
    }

    QWidget window;
    ui::StrokeRevision revision;
};

} // namespace

class StrokeRevisionUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// The stroke that was removed comes back, with what was made of it before.
    void aChangedStrokeComesBackAsItWas()
    {
        RevisionFixture fixture;
        fixture.apply(test::drillAt(0));
        const QByteArray drawn = fixture.session().stateHash();
        fixture.apply(core::ReviseStroke{.row = 1, .radiusMm = 6.0});
        fixture.apply(core::ReviseStroke{.row = 1, .radiusMm = 7.5});
        const QByteArray changed = fixture.session().stateHash();
        QVERIFY(changed != drawn);
        fixture.remove(1);
        QVERIFY(fixture.revision.isRemoved(1));
        QVERIFY(fixture.session().stateHash() != changed);
        fixture.restore(1);
        QVERIFY(!fixture.revision.isRemoved(1));
        QCOMPARE(fixture.last().row, std::int64_t(1));
        QCOMPARE(fixture.last().radiusMm.value_or(0.0), 7.5);
        QVERIFY(!fixture.last().removed);
        QCOMPARE(fixture.session().stateHash(), changed);
        // Also the second time.
        fixture.remove(1);
        fixture.restore(1);
        QCOMPARE(fixture.session().stateHash(), changed);
    }

    /// Into the layer that it was drawn in, if the one that it was moved to is gone.
    void aStrokeWhoseLayerIsGone()
    {
        RevisionFixture fixture;
        fixture.apply(test::drillAt(0));
        fixture.apply(core::AddLayer{.name = QStringLiteral("Other")});
        fixture.apply(core::ReviseStroke{.row = 1, .radiusMm = 7.5, .layer = 2});
        fixture.remove(1);
        fixture.apply(core::RemoveLayer{.layer = 2});
        fixture.restore(1);
        QVERIFY(!fixture.revision.isRemoved(1));
        QCOMPARE(fixture.last().radiusMm.value_or(0.0), 7.5);
        QVERIFY(!fixture.last().layer);
    }

    void oneThatWasNeverChangedComesBackAsDrawn()
    {
        RevisionFixture fixture;
        fixture.apply(test::drillAt(0));
        const QByteArray drawn = fixture.session().stateHash();
        fixture.apply(test::drillAt(5));
        // What was made of another stroke is nothing to this one.
        fixture.apply(core::ReviseStroke{.row = 2, .radiusMm = 7.5});
        fixture.apply(core::ReviseStroke{.row = 2, .removed = true});
        fixture.remove(1);
        fixture.restore(1);
        QVERIFY(!fixture.last().radiusMm && !fixture.last().removed);
        QCOMPARE(fixture.session().stateHash(), drawn);
    }

    /// Its rows have the numbers of those of the study before.
    void theNextStudyHasOffersOfItsOwn()
    {
        RevisionFixture fixture;
        int offers = 0;
        connect(&fixture.workspace, &ui::Workspace::offered, this,
            [&offers](const auto&) { ++offers; });
        const auto removeTheFirst = [&fixture] {
            fixture.apply(test::drillAt(0));
            fixture.apply(test::drillWith({.radiusMm = 3.0}, test::drillAt(1)));
            fixture.remove(1);
        };
        removeTheFirst();
        QCOMPARE(offers, 1);
        fixture.openTheNext();
        removeTheFirst();
        QCOMPARE(offers, 2);
    }

    /// A menu may have been open while the study was closed.
    void withoutAStudyThereIsNothingToChange()
    {
        RevisionFixture fixture;
        fixture.apply(test::drillAt(0));
        fixture.workspace.setSession(nullptr);
        fixture.revision.change(1);
        fixture.revision.remove(1);
        fixture.revision.restore(1);
        QVERIFY(fixture.window.findChildren<QDialog*>().isEmpty());
    }
};

BURIN_WINDOW_TEST(StrokeRevisionUiTest)

} // namespace strokeRevisionUiTest

#include "StrokeRevisionUiTest.moc"
