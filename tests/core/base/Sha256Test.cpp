// SPDX-License-Identifier: Apache-2.0
#include "core/base/Sha256.h"
#include "tests/support/program/TestProgram.h"

#include <QCryptographicHash>
#include <QtTest>

#include <algorithm>
#include <utility>

namespace sha256Test {

using core::Sha256;

class Sha256Test : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void knownDigests_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QByteArray>("hex");
        QTest::addRow("nothing")
            << QByteArray()
            << QByteArray("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        QTest::addRow("abc")
            << QByteArray("abc")
            << QByteArray("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        QTest::addRow("a million times a") << QByteArray(1'000'000,
            'a') << QByteArray("cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    }

    /// FIPS 180-2, appendix B.
    void knownDigests()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QByteArray, hex);
        Sha256 hash;
        hash.add(bytes);
        QCOMPARE(hash.takeHex(), hex);
    }

    void piecesAreTheWhole()
    {
        QByteArray bytes;
        for (int i = 0; i < 1000; ++i)
            bytes.append(char(i * 37));
        Sha256 hash;
        for (qsizetype at = 0, size = 0; at < bytes.size(); at += size, size = (size + 7) % 131)
            hash.add(QByteArrayView(bytes).sliced(at, std::min(size, bytes.size() - at)));
        Sha256 moved = std::move(hash);
        QCOMPARE(
            moved.takeHex(), QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
    }
};

BURIN_TEST(Sha256Test)

} // namespace sha256Test

#include "Sha256Test.moc"
