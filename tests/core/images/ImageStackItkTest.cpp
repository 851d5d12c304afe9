// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/peers/readers/ItkPictures.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/ImageFiles.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/VolumeFiles.h"

#include <QTest>

#include <tiff.h>

namespace imageStackItkTest {

using test::picture;
using test::writeTiff;

/// Pictures as ITK (which reads tiles of 16 bits as zeros), which 3D Slicer and ITK-SNAP read them
/// with, has them: value by value.
class ImageStackItkTest : public QObject, protected test::VolumeFiles {
    Q_OBJECT

private Q_SLOTS:
    void init() { makeFolder(); }

    void pagesOfATiff_data();
    void pagesOfATiff();
    void filesOfAFolder_data();
    void filesOfAFolder();

private:
    void compare(const QString& path, const std::vector<std::string>& files)
    {
        const core::LoadedVolume loaded =
            test::openVolume(path, QStringLiteral("+spacing=0.5x0.5x2"));
        const peer::ItkPictures itk = peer::readItkPictures(files);
        QVERIFY2(itk.error.empty(), itk.error.c_str());
        QCOMPARE(loaded.volume.geometry.size, itk.size);
        QCOMPARE(loaded.codes.size(), itk.values.size());
        for (std::size_t voxel = 0; voxel < itk.values.size(); ++voxel) {
            const double value = loaded.volume.encoding.value(loaded.codes[voxel]);
            QVERIFY2(std::abs(value - itk.values[voxel]) < 1e-3,
                qPrintable(
                    QStringLiteral("%1: %2, ITK %3").arg(voxel).arg(value).arg(itk.values[voxel])));
        }
    }
};

void ImageStackItkTest::pagesOfATiff_data()
{
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("compression");
    QTest::addColumn<bool>("bigEndian");
    QTest::addRow("8 bits") << 0 << int(COMPRESSION_NONE) << false;
    QTest::addRow("16 bits, big endian, LZW") << 1 << int(COMPRESSION_LZW) << true;
    QTest::addRow("16 bits, signed, deflate") << 2 << int(COMPRESSION_ADOBE_DEFLATE) << false;
    QTest::addRow("floating point, big endian") << 3 << int(COMPRESSION_NONE) << true;
}

void ImageStackItkTest::pagesOfATiff()
{
    QFETCH(int, type);
    QFETCH(int, compression);
    QFETCH(bool, bigEndian);
    using Make = test::PictureBytes (*)(int, int, int);
    const std::array<Make, 4> makers{
        picture<std::uint8_t>, picture<std::uint16_t>, picture<std::int16_t>, picture<float>};
    std::vector<test::PictureBytes> pages;
    for (int k = 0; k < 4; ++k)
        pages.push_back(makers[std::size_t(type)](k, 37, 23));
    const QString file = m_folder->filePath(QStringLiteral("pages.tif"));
    QVERIFY(writeTiff(file, pages, {.bigEndian = bigEndian, .compression = compression}));
    compare(file, {file.toStdString()});
}

void ImageStackItkTest::filesOfAFolder_data()
{
    QTest::addColumn<bool>("isPng");
    QTest::addRow("PNG") << true;
    QTest::addRow("TIFF, LZW") << false;
}

void ImageStackItkTest::filesOfAFolder()
{
    QFETCH(bool, isPng);
    std::vector<std::string> files;
    for (int k = 0; k < 12; ++k) {
        const test::PictureBytes slice = picture<std::uint16_t>(k, 40, 24);
        const QString name = QStringLiteral("z%1.%2").arg(k).arg(
            isPng ? QStringLiteral("png") : QStringLiteral("tif"));
        const QString file = m_folder->filePath(name);
        if (isPng)
            put(name, test::png(slice));
        else
            QVERIFY(writeTiff(file, {slice}, {.compression = COMPRESSION_LZW}));
        files.push_back(file.toStdString());
    }
    compare(m_folder->path(), files);
}

BURIN_TEST(ImageStackItkTest)

} // namespace imageStackItkTest

#include "ImageStackItkTest.moc"
