// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/FrameMail.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <utility>

namespace frameMailTest {

using namespace gpu;

namespace {

constexpr ViewId view = 1;

/// The mail between one view and the thread that draws it.
struct Exchange {
    Exchange()
    {
        mail.setListener([this](const Frame&) { ++handed; });
    }
    void request()
    {
        FrameRequest wanted;
        wanted.view = view;
        mail.request(std::move(wanted));
    }
    void hand()
    {
        Frame drawn;
        drawn.view = view;
        mail.hand(drawn);
    }

    FrameMail mail;
    int handed = 0;
};

} // namespace

class FrameMailTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// A view asks for the next picture before the last one has come.
    void aNewerRequestHoldsNothingBack()
    {
        Exchange exchange;
        exchange.request();
        static_cast<void>(exchange.mail.take());
        exchange.request();
        exchange.hand();
        QCOMPARE(exchange.handed, 1);
        QVERIFY(!exchange.mail.take().requests.at(view).fresh);
    }

    /// It was hidden and is shown again while its picture of before is still on its way.
    void nothingOfBeforeComesToAViewThatAsksAgain()
    {
        Exchange exchange;
        exchange.request();
        static_cast<void>(exchange.mail.take());
        exchange.mail.forget(view);
        exchange.hand();
        QCOMPARE(exchange.handed, 0);
        exchange.request();
        exchange.hand(); // whoever draws does not know of the request yet
        QCOMPARE(exchange.handed, 0);
        exchange.request(); // and it moves on at once
        exchange.hand();
        QCOMPARE(exchange.handed, 0);
        QVERIFY(exchange.mail.take().requests.at(view).fresh);
        exchange.hand();
        QCOMPARE(exchange.handed, 1);
    }
};

BURIN_TEST(FrameMailTest)

} // namespace frameMailTest

#include "FrameMailTest.moc"
