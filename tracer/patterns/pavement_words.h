// What borders the cells of pavements have (textures, annex B): one letter for each cell, a word of
// bits for each letter.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace durer::tracer::patterns {

struct PavementRow {
  int tiles;
  int pattern;
  std::string_view letters;
};

/// What the letters a, b, c … mean for tiles of 4 sides.
inline constexpr std::array<std::uint16_t, 30> pavement_bits_4{
    0x1, 0x3, 0x4, 0x5, 0x6, 0x7, 0x9, 0xA, 0xB, 0xC, 0xD, 0xE, 0xF, 0x12, 0x14, 0x16, 0x24,
    0x2C, 0x34, 0x41, 0x48, 0x49, 0x68, 0x81, 0x82, 0x83, 0x92, 0xC1, 0xD0, 0xF0,
};
inline constexpr std::array<PavementRow, 55> pavement_rows_4{{
    {2, 1, "li"},
    {3, 1, "kdfkdf"},
    {3, 2, "lkpvfi"},
    {4, 1, "kddfkddfkddfkddf"},
    {4, 2, "lkdpvdfilkdpvdfi"},
    {4, 3, "ksfifiksksfifiks"},
    {4, 4, "jejegbgbjejegbgb"},
    {4, 5, "frfrkzkzrfrfzkzk"},
    {5, 1, "kdddfkdddf"},
    {5, 2, "lkddpvddfi"},
    {5, 3, "fjejqkxbgb"},
    {5, 4, "kdsfimmmmm"},
    {5, 5, "kDfilmmmmm"},
    {5, 6, "lhvdfkdphi"},
    {5, 7, "ilvpvfkpvp"},
    {5, 8, "rdpililvdz"},
    {5, 9, "lvdpilvdpi"},
    {5, 10, "lkBpivsfil"},
    {5, 11, "frdfrkzkdz"},
    {5, 12, "ksfkBfhilh"},
    {6, 1, "kddddfkddddf"},
    {6, 2, "rdddflikdddz"},
    {6, 3, "ksddflfikddB"},
    {6, 4, "kdsdfldfikdB"},
    {6, 5, "kzrddfmmmmmm"},
    {6, 6, "jqdfjegbkdxb"},
    {6, 7, "fjekoqkxtfgb"},
    {6, 8, "kdzrdfmmmmmm"},
    {6, 9, "fjqfjqkxbkxb"},
    {6, 10, "jcejcegabgab"},
    {6, 11, "lkoeuegngtfi"},
    {6, 12, "kdpvpimmmmmm"},
    {6, 13, "ksdplilivdBf"},
    {6, 14, "ksfphkhvfBfk"},
    {6, 15, "koylgbmmmmmm"},
    {6, 16, "lkCegbmmmmmm"},
    {6, 17, "kDdflilikdDf"},
    {6, 18, "likddAwddfli"},
    {6, 19, "lvdphimmmmmm"},
    {6, 20, "irddzlmmmmmm"},
    {6, 21, "ihrddfmmmmmm"},
    {6, 22, "rddpillidzvd"},
    {6, 23, "hkBpvsfhlili"},
    {6, 24, "kpkdAilwdfvf"},
    {6, 25, "kpkppvpvvfvf"},
    {6, 26, "jejegngnfvfv"},
    {6, 27, "rfrfAkAkvfvf"},
    {6, 28, "lvdpvfmmmmmm"},
    {6, 29, "kpilvfpvdzrd"},
    {6, 30, "flvsfvkBpikp"},
    {6, 31, "rdBfliiksdzl"},
    {6, 32, "liksBfmmmmmm"},
    {6, 33, "kdprfhhkzvdf"},
    {6, 34, "rBdflilikdsz"},
    {6, 35, "hkdAwdfhilli"},
}};

/// What the letters a, b, c … mean for tiles of 3 sides.
inline constexpr std::array<std::uint16_t, 21> pavement_bits_3{
    0x0, 0x3, 0x4, 0x5, 0x6, 0x122, 0x126, 0x144, 0x146, 0x211, 0x215, 0x244, 0x245, 0x344,
    0x3C4, 0x413, 0x423, 0x522, 0x5A2, 0x611, 0x691,
};
inline constexpr std::array<PavementRow, 20> pavement_rows_3{{
    {3, 1, "knggnk"},
    {4, 1, "gghhgghh"},
    {4, 2, "tngqtngq"},
    {4, 3, "daebadbe"},
    {5, 1, "klchgghclk"},
    {5, 2, "kllttllkqq"},
    {5, 3, "ignttngirr"},
    {5, 4, "dalkbbklad"},
    {6, 1, "klcclkklcclk"},
    {6, 2, "prhclkprhclk"},
    {6, 3, "bghalkbghalk"},
    {6, 4, "klcaebclkbea"},
    {6, 5, "dalkmjdjmkla"},
    {6, 6, "mjklljmjllkj"},
    {6, 7, "klltriirtllk"},
    {6, 8, "dalkiffiklad"},
    {6, 9, "daegnjdjngea"},
    {6, 10, "knffnkknffnk"},
    {6, 11, "daeeadeaddae"},
    {6, 12, "uossousouuos"},
}};

/// What the letters a, b, c … mean for tiles of 6 sides.
inline constexpr std::array<std::uint16_t, 20> pavement_bits_6{
    0x80, 0x91, 0xA2, 0xC4, 0x1A2, 0x1C4, 0x291, 0x2C4, 0x3C4, 0x491, 0x4A2, 0x5A2, 0x691,
    0x6A2, 0x1080, 0x2080, 0x3080, 0x4080, 0x5080, 0x6080,
};
inline constexpr std::array<PavementRow, 34> pavement_rows_6{{
    {1, 1, "millim"},
    {2, 1, "mieeimlfttfl"},
    {3, 1, "millimlimjqkjqkkqjkqjjqkjqkkqjkqjmil"},
    {3, 2, "mieeimlfrppkmhroojliggiljoorhmkpprfl"},
    {3, 3, "mieeiggillfttdsshmlfttdsshmmieeiggil"},
    {4, 1, "millimlimjqkjqkkqjkqjjqkjqkkqjkqjjqkjqkkqjkqjmil"},
    {4, 2, "mhroaprhmgierfleiglfrpaomhroaprhmgierfleiglfrpao"},
    {4, 3, "mhssdttdsshmliggieeiggilmhssdttdsshmliggieeiggil"},
    {4, 4, "milkqjeimmiltfleimlfttfljqclftkqjjqcjqkkqjkqjjqk"},
    {4, 5, "mielftshmjqcgilkqbligmhsmhsshmeimbqktflcqjlfttfl"},
    {4, 6, "milcqjlfrppkmhroojliggiljoorhmkpprfljqclimkqjjqk"},
    {4, 7, "mileimbqcligsdttflkqjmhsbqcligmileimkqjmhssdttfl"},
    {5, 1, "millimlimjqkjqkkqjkqjjqkjqkkqjkqjjqkjqkkqjkqjjqkjqkkqjkqjmil"},
    {5, 2, "tfleimlfttfljqclftkqjjqcjqkkqjkqjjqkjqkkqjkqjjqkmilkqjeimmil"},
    {5, 3, "mieeimlfrppkmhroojlimbqkjqkkqjkqjjqkjqkkqjkqbmiljoorhmkpprfl"},
    {5, 4, "milcqjlfrppkmhroojlimbqkjqkkqjkqbmiljoorhmkpprfljqclimkqjjqk"},
    {5, 5, "tflcqjlfttfljqclftkqjjqcjqkkqjkqjjqkmilkqjlimmiljqklimcqjjqk"},
    {5, 6, "mieeimlfrppkjoaaojkpprfljqclimkqjjqkmilcqjlfrppkjoaaojkpprfl"},
    {5, 7, "mhroojliggiljoorhmkpaapkjoaaojkpprflmieeimlfrppkjoaaojkpaapk"},
    {5, 8, "tfllfrmhrrhmrfllftmielftjqckqbjookppmieeimppkoojbqkcqjtfleim"},
    {5, 9, "tdsshgligghsmhsshmshmbqkbqkkqjkqjjqkmilcqjlfttflmielfteigmie"},
    {5, 10, "mieeimsdttflgieeiglfttdsjqclimnqjjqkmilcqjsdttflgieeiglfttds"},
    {5, 11, "mieeimlfrppkjoaaobkpprdsmieligshmmhsgileimsdrppkboaaojkpprfl"},
    {5, 12, "gileimrdrppkrdroojliggiljoordrkpprdrmieligeimjooppkkppoojmie"},
    {5, 13, "mhsshmshmbqkgilcqjsdttflgieeiglfttdsjqcligkqbmhsmhsshmliggil"},
    {5, 14, "millimlimjqkjqkkqbkqbmhsmhsshgshgghsghsshmshmbqkbqkkqjkqjmil"},
    {5, 15, "gillimlimjqkjqkkqjkqjjqkjqkkqbkqbmhsmhsshgshgghsghsshmshmgil"},
    {5, 16, "mhssdreimghrppklimoojjqkbqkkqbkqjjoomilkpprhgmierdsshmliggil"},
    {5, 17, "rfeefrlfttdrmielimeimjqkppkkqboojjoobqkkppkqjmiemileimrdttfl"},
    {5, 18, "gieeiglfttdsmielimshmjqkbqkkqjkqjjqkjqkkqbkqjmhsmileimsdttfl"},
    {5, 19, "bqklimkqjjqkmilcqblfttdsmieeimsdttflbqclimkqjjqkmilkqbshmmhs"},
    {5, 20, "mieeimlfrppkmhroobshmghsbqklimkqjjqkmilkqbshgmhsboorhmkpprfl"},
    {5, 21, "gillimlimjqkjqkkqbkqbmhsmhsshmshmbqkbqkkqbkqbmhsmhsshmshmgil"},
    {5, 22, "mieligshmmhsgileimsdttflbqclimkqjjqkjqkkqjkqjjqkmilcqblfttds"},
}};

}  // namespace durer::tracer::patterns
