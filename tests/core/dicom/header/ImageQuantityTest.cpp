// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/ImageQuantity.h"
#include "core/dicom/stack/QuantitySplit.h"

#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace imageQuantityTest {

/// What an image measures, by the words of its header.
class ImageQuantityTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void words_data();
    void words();
    void everyPlaceMustHaveEveryQuantity();
};

void ImageQuantityTest::words_data()
{
    QTest::addColumn<QString>("type");
    QTest::addColumn<QString>("component");
    QTest::addColumn<QString>("quantity");
    const auto row = [](const char* type, const char* component, const char* quantity) {
        QTest::addRow("%s, %s", type, component)
            << QString::fromLatin1(type) << QString::fromLatin1(component)
            << QString::fromLatin1(quantity);
    };
    row("ORIGINAL\\PRIMARY\\M_FFE\\M\\FFE", "", "magnitude");
    row("ORIGINAL\\PRIMARY\\R_IR", "", "real part");
    row("ORIGINAL\\PRIMARY\\PHASE MAP\\P\\FFE", "", "phase");
    row("ORIGINAL\\PRIMARY\\B0 MAP\\B0\\UNSPECIFIED", "MAGNITUDE", "field map");
    row("original\\primary\\p\\nd", "", "phase");
    row("ORIGINAL\\PRIMARY\\DIXON\\WATER", "MAGNITUDE", "water");
    row("DERIVED\\PRIMARY\\DIFFUSION\\ADC", "MIXED", "ADC map");
    row("ORIGINAL\\PRIMARY\\T1\\NONE", "", "T1 map");
    row("ORIGINAL\\PRIMARY\\OTHER", "IMAGINARY", "imaginary part");
    row("ORIGINAL\\PRIMARY\\AXIAL\\ADD", "", "");
    row("M\\P", "", "");
    row("", "", "");
}

void ImageQuantityTest::words()
{
    QFETCH(QString, type);
    QFETCH(QString, component);
    QTEST(core::imageQuantity(type, component).english(), "quantity");
}

void ImageQuantityTest::everyPlaceMustHaveEveryQuantity()
{
    std::vector<core::SlicePlace> places(3);
    for (core::SlicePlace& place : places) {
        for (const char* quantity : {"phase", "magnitude"}) {
            core::ImageHeader image;
            image.quantity = QString::fromLatin1(quantity);
            place.images.push_back(image);
        }
    }
    std::vector<core::SlicePlace> lacking = places;
    lacking[1].images.pop_back();
    QVERIFY(core::takeApartByQuantity(lacking).empty());
    QCOMPARE(lacking[0].images.size(), std::size_t(2));
    std::vector<core::SlicePlace> silent = places;
    silent[2].images[0].quantity = {};
    QVERIFY(core::takeApartByQuantity(silent).empty());
    const std::vector<core::QuantityImages> apart = core::takeApartByQuantity(places);
    QCOMPARE(apart.size(), std::size_t(2));
    QCOMPARE(apart[0].images.size(), std::size_t(3));
    QCOMPARE(apart[1].images.size(), std::size_t(3));
}

BURIN_TEST(ImageQuantityTest)

} // namespace imageQuantityTest

#include "ImageQuantityTest.moc"
