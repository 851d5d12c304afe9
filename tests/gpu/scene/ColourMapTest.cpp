// SPDX-License-Identifier: Apache-2.0
#include "gpu/scene/ColourMap.h"
#include "tests/support/program/TestProgram.h"

#include <QCryptographicHash>
#include <QTest>

#include <cmath>
#include <vector>

namespace colourMapTest {

using namespace gpu;

namespace {

/// Red, green and blue of each entry, as bytes.
QByteArray bytesOf(const ColourEntries& entries)
{
    QByteArray bytes;
    for (const std::uint32_t rgb : entries)
        for (const int shift : {16, 8, 0})
            bytes.append(char(rgb >> shift & 255U));
    return bytes;
}

/// CIE L* of an sRGB colour: 0 … 100.
double lightness(std::uint32_t rgb)
{
    const auto linear = [rgb](int shift) {
        const double share = (rgb >> shift & 255U) / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126729 * linear(16) + 0.7151522 * linear(8) + 0.0721750 * linear(0);
    return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

} // namespace

class ColourMapTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void greyIsGrey()
    {
        for (std::uint32_t i = 0; i < 256; ++i)
            QCOMPARE(entriesOf(ColourMap::Grey)[i], i * 0x010101U);
    }

    /// SHA-256 of the palette colour look-up tables that DICOM publishes with these names
    /// (1.2.840.10008.1.5.1, .3 and .4), red, green and blue of an entry in turn.
    void palettesAreThoseOfDicom_data()
    {
        QTest::addColumn<int>("map");
        QTest::addColumn<QByteArray>("sha256");
        QTest::newRow("HOT_IRON")
            << int(ColourMap::HotIron)
            << QByteArray("8bba464199e149c18cf501e8174289abf693e5af4a7db4c1602ad48dd4338dda");
        QTest::newRow("HOT_METAL_BLUE")
            << int(ColourMap::HotMetalBlue)
            << QByteArray("a421277b84abae409188b25c2fba742ad459dc30356a4aebd37ceb33a94718f9");
        QTest::newRow("PET_20_STEP")
            << int(ColourMap::Pet20Step)
            << QByteArray("6f4f77ec9646ab6c536f1abe9e755ab548dfd0a4e71c4bfe130be2bd355c54ac");
    }

    void palettesAreThoseOfDicom()
    {
        QFETCH(int, map);
        QFETCH(QByteArray, sha256);
        const QByteArray bytes = bytesOf(entriesOf(ColourMap(map)));
        QCOMPARE(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex(), sha256);
    }

    void lightnessGrowsEvenly()
    {
        const ColourEntries& entries = entriesOf(ColourMap::EvenLightness);
        const double first = lightness(entries.front());
        const double last = lightness(entries.back());
        QVERIFY(first < 5.0 && last > 95.0);
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const double even = first + (last - first) * double(i) / 255.0;
            QVERIFY2(std::abs(lightness(entries[i]) - even) < 1.0, qPrintable(QString::number(i)));
            QVERIFY(i == 0 || lightness(entries[i]) >= lightness(entries[i - 1]));
        }
    }
};

BURIN_TEST(ColourMapTest)

} // namespace colourMapTest

#include "ColourMapTest.moc"
