#include "fastscene/rooms/lexicon.h"

#include <algorithm>
#include <map>

#include "fastscene/rooms/style.h"

namespace fastscene {
namespace {

// A line: the meaning, then the terms for it, separated by commas. "~" before a term: only the nearest thing we have.
struct Line {
    WordKind kind;
    const char *meaning, *terms;
};

constexpr Line kLines[] = {
    {WordKind::room, "living", "living room,livingroom,lounge,sitting room,parlor,parlour,family room,drawing room,salon,~den,~great room,~apartment,~flat,~living space"},
    {WordKind::room, "bedroom", "bedroom,bed room,master bedroom,guest room,guest bedroom,boudoir,~hotel room,sleeping room,~dorm room,~dormitory"},
    {WordKind::room, "kids", "kids room,kid room,children room,childrens room,nursery,playroom,child room,teen room,teenager room,baby room,kids bedroom,childrens bedroom"},
    {WordKind::room, "kitchen", "kitchen,kitchenette,galley kitchen,~pantry,~bakery"},
    {WordKind::room, "dining", "dining room,diningroom,breakfast room,dining hall,~restaurant,~cafe,~banquet hall"},
    {WordKind::room, "bathroom", "bathroom,bath room,washroom,restroom,~spa,powder room,ensuite,~wet room,~shower room"},
    {WordKind::room, "study", "study,home office,office,library,study room,reading room,workroom,workspace,~classroom,~music room,~conference room,home library"},
    {WordKind::room, "hallway", "hallway,hall,entrance hall,entryway,foyer,corridor,vestibule,~lobby,entrance"},
    {WordKind::room, "loft", "loft,studio,studio loft,studio apartment,~atelier,~art studio,~warehouse"},
    {WordKind::room, "laundry", "laundry,laundry room,utility room,~mudroom,~storage room"},
    {WordKind::room, "sunroom", "sunroom,sun room,conservatory,winter garden,~balcony,~veranda,garden room"},
    {WordKind::room, "attic", "attic,garret,attic room,~basement,~cellar"},

    {WordKind::style, "modern", "modern,contemporary,minimalist,minimal,minimalistic,sleek,~futuristic,~high tech,modernist,~luxurious modern,clean"},
    {WordKind::style, "scandinavian", "scandinavian,scandi,nordic,swedish,danish,norwegian,finnish,hygge"},
    {WordKind::style, "japandi", "japandi,japanese,zen,wabi sabi,~asian,~korean"},
    {WordKind::style, "industrial", "industrial,urban,steampunk,factory style,~grunge"},
    {WordKind::style, "classic", "classic,classical,traditional,victorian,luxury,luxurious,elegant,neoclassical,baroque,rococo,royal,~european,~french,~english,~georgian,~chinoiserie,antique"},
    {WordKind::style, "boho", "boho,bohemian,eclectic,~moroccan,~hippie,~ethnic,~indian"},
    {WordKind::style, "rustic", "rustic,farmhouse,country,cottage,cabin,~medieval,~alpine,chalet,countryside,~shabby chic"},
    {WordKind::style, "mid-century", "mid century,midcentury,retro,vintage,mid century modern,~seventies,~sixties"},
    {WordKind::style, "mediterranean", "mediterranean,spanish,italian,greek,tuscan,provencal,coastal,~tropical,~beach,~nautical"},
    {WordKind::style, "art deco", "art deco,deco,glamorous,gatsby,~hollywood,~glam"},

    {WordKind::object, "bed", "bed,double bed,king bed,queen bed,king size bed,queen size bed,four poster bed,canopy bed,platform bed,~hammock,~daybed,~futon"},
    {WordKind::object, "bed_single", "single bed,twin bed,kids bed,child bed,~bunk bed"},
    {WordKind::object, "nightstand", "nightstand,night stand,bedside table,night table,bedside cabinet"},
    {WordKind::object, "wardrobe", "wardrobe,closet,armoire,~locker"},
    {WordKind::object, "dresser", "dresser,chest of drawers,drawers,commode,~dressing table,~chest"},
    {WordKind::object, "sofa", "sofa,couch,settee,chesterfield,~davenport,sectional,~divan,corner sofa,~sofa bed,three seater"},
    {WordKind::object, "loveseat", "loveseat,love seat,two seater,~chaise longue,~chaise"},
    {WordKind::object, "armchair", "armchair,arm chair,recliner,lounge chair,easy chair,club chair,wing chair,reading chair,~rocking chair,accent chair,wingback"},
    {WordKind::object, "ottoman", "ottoman,footstool,hassock"},
    {WordKind::object, "pouf", "pouf,pouffe,floor cushion,~bean bag,~beanbag"},
    {WordKind::object, "coffee_table", "coffee table,cocktail table,low table,tea table"},
    {WordKind::object, "side_table", "side table,end table,~pedestal,~table"},
    {WordKind::object, "console_table", "console table,console,hall table"},
    {WordKind::object, "dining_table", "dining table,kitchen table,big table,~conference table,~pool table,~billiard table"},
    {WordKind::object, "dining_table_round", "round table,round dining table,bistro table,cafe table"},
    {WordKind::object, "chair", "chair,dining chair,wooden chair,~seat"},
    {WordKind::object, "stool", "stool"},
    {WordKind::object, "bar_stool", "bar stool,barstool,counter stool"},
    {WordKind::object, "bench", "bench,~window seat,~pew"},
    {WordKind::object, "desk", "desk,writing desk,work desk,computer desk,bureau,~workbench,~standing desk,~computer"},
    {WordKind::object, "office_chair", "office chair,desk chair,swivel chair,gaming chair"},
    {WordKind::object, "bookshelf", "bookshelf,bookcase,book shelf,book case,shelving unit,bookshelves,~shelving,~wine rack"},
    {WordKind::object, "shelf", "shelf,wall shelf,floating shelf,shelves"},
    {WordKind::object, "ladder_shelf", "ladder shelf,leaning shelf"},
    {WordKind::object, "sideboard", "sideboard,credenza,buffet"},
    {WordKind::object, "cabinet", "cabinet,cupboard,~hutch,~display cabinet,~bar cabinet,~china cabinet"},
    {WordKind::object, "tv_stand", "tv stand,tv unit,media console,tv cabinet,entertainment center,tv console"},
    {WordKind::object, "tv", "tv,television,flat screen,tv screen,~screen,~projector screen"},
    {WordKind::object, "kitchen_counter", "kitchen counter,counter,worktop,kitchen cabinets,kitchen units,~stove,~oven,~sink,~kitchen sink,~countertop"},
    {WordKind::object, "kitchen_island", "kitchen island,island,breakfast bar,~bar counter,~bar"},
    {WordKind::object, "fridge", "fridge,refrigerator,~freezer,~wine fridge"},
    {WordKind::object, "washing_machine", "washing machine,washer,~dryer,~dishwasher,~tumble dryer"},
    {WordKind::object, "toilet", "toilet,wc,loo,~bidet"},
    {WordKind::object, "bathtub", "bathtub,bath tub,bath,tub,clawfoot tub,freestanding tub,~jacuzzi,~hot tub"},
    {WordKind::object, "shower", "shower,shower cabin,shower stall,walk in shower"},
    {WordKind::object, "washbasin", "vanity,washbasin,wash basin,basin,bathroom sink,~washstand"},
    {WordKind::object, "mirror", "mirror,wall mirror,full length mirror,~looking glass"},
    {WordKind::object, "towel_rail", "towel rail,towel rack,towel,towels"},
    {WordKind::object, "floor_lamp", "floor lamp,standing lamp,arc lamp,~lamp post"},
    {WordKind::object, "table_lamp", "table lamp,bedside lamp,desk lamp,lamp,reading lamp,~lantern,~sconce,~wall lamp"},
    {WordKind::object, "pendant_lamp", "pendant lamp,pendant light,pendant,hanging lamp,pendant lights,hanging light"},
    {WordKind::object, "ceiling_lamp", "ceiling lamp,ceiling light,~ceiling fan,~downlight,~spotlight,~track light"},
    {WordKind::object, "chandelier", "chandelier,candelabra,crystal chandelier"},
    {WordKind::object, "plant", "plant,potted plant,houseplant,house plant,fern,ficus,monstera,greenery,rubber plant,snake plant,indoor plant"},
    {WordKind::object, "plant_tree", "palm,palm tree,indoor tree,potted tree,fiddle leaf fig,~tree,~olive tree,~lemon tree"},
    {WordKind::object, "plant_small", "small plant,succulent,herbs,~bonsai,~cactus,~orchid,~flowers in pots"},
    {WordKind::object, "vase", "vase,flower vase,~flower,~flowers,~bouquet,~roses,~tulips,~urn,~amphora"},
    {WordKind::object, "vase_small", "bud vase,small vase"},
    {WordKind::object, "cat", "cat,sleeping cat,kitten,~dog,~pet"},
    {WordKind::object, "picture", "picture,painting,artwork,art,poster,print,framed picture,canvas,photograph,~tapestry,wall art,~photo,frame,~map"},
    {WordKind::object, "rug", "rug,area rug,persian rug,mat,~runner,~sheepskin,round rug,~tatami"},
    {WordKind::object, "curtain", "curtain,drapes,draperies,~blinds,~shutters,~blind"},
    {WordKind::object, "basket", "basket,hamper,laundry basket,wicker basket,~crate"},
    {WordKind::object, "book_stack", "book,stack of books,book stack,~magazine,~newspaper"},
    {WordKind::object, "bowl", "bowl,fruit bowl,~fruit,~plate,~dish"},
    {WordKind::object, "candle", "candle,candlestick,candle holder"},
    {WordKind::object, "clock", "clock,wall clock,~grandfather clock"},
    {WordKind::object, "fireplace", "fireplace,fire place,hearth,~wood stove,chimney,mantel,mantelpiece"},
    {WordKind::object, "piano", "piano,grand piano,upright piano,~keyboard,~organ,~harpsichord"},
    {WordKind::object, "guitar", "guitar,electric guitar,acoustic guitar,~violin,~cello,~ukulele,~bass"},
    {WordKind::object, "aquarium", "aquarium,fish tank,~terrarium"},
    {WordKind::object, "crib", "crib,cot,baby bed,cradle"},
    {WordKind::object, "toy_box", "toy box,toy,toys,~teddy bear,~doll house,~dollhouse"},
    {WordKind::object, "rocking_horse", "rocking horse"},
    {WordKind::object, "coat_rack", "coat rack,coat stand,hat stand,~coat hanger"},
    {WordKind::object, "shoe_rack", "shoe rack,shoe cabinet,~shoes"},
    {WordKind::object, "radiator", "radiator,heater"},
    {WordKind::object, "cushion", "cushion,pillow,throw pillow,~blanket,~throw"},

    {WordKind::structure, "window", "window,bay window,french window,skylight,picture window"},
    {WordKind::structure, "door", "door,doorway,~sliding door"},
    {WordKind::structure, "wall", "wall,accent wall,wallpaper,walls,~paneling,~panelling"},
    {WordKind::structure, "floor", "floor,flooring,floorboards,~parquetry"},
    {WordKind::structure, "ceiling", "ceiling,~roof"},
    {WordKind::structure, "beams", "beam,exposed beams,wooden beams,ceiling beams"},

    {WordKind::material, "wood", "wood,wooden,timber,hardwood,~bamboo,~plywood"},
    {WordKind::material, "oak", "oak,oaken"},
    {WordKind::material, "walnut", "walnut"},
    {WordKind::material, "pine", "pine"},
    {WordKind::material, "leather", "leather,faux leather,leathery"},
    {WordKind::material, "velvet", "velvet,velvety,plush"},
    {WordKind::material, "linen", "linen,cotton,fabric,cloth,textile,upholstered"},
    {WordKind::material, "wool", "wool,woolen,knitted,knit"},
    {WordKind::material, "marble", "marble"},
    {WordKind::material, "terrazzo", "terrazzo"},
    {WordKind::material, "concrete", "concrete,cement"},
    {WordKind::material, "brick", "brick,exposed brick,bricks"},
    {WordKind::material, "tile", "tile,tiled,ceramic,~mosaic,porcelain"},
    {WordKind::material, "stone", "stone,granite,slate stone,~limestone,~sandstone"},
    {WordKind::material, "metal", "metal,metallic,steel,iron,wrought iron,stainless steel,aluminium,aluminum"},
    {WordKind::material, "brass", "brass"},
    {WordKind::material, "glass", "glass,crystal"},
    {WordKind::material, "rattan", "rattan,wicker,cane,woven"},
    {WordKind::material, "carpet", "carpet,carpeted"},
    {WordKind::material, "parquet", "parquet,herringbone,chevron"},
    {WordKind::material, "planks", "plank,planks,laminate,~vinyl"},
    {WordKind::material, "plaster", "plaster,stucco"},

    {WordKind::pattern, "striped", "striped,stripes,stripe,pinstriped"},
    {WordKind::pattern, "floral", "floral,flowery,flowered,botanical"},
    {WordKind::pattern, "checkered", "checkered,checked,plaid,tartan,gingham,chequered,checkerboard"},
    {WordKind::pattern, "damask", "damask,ornate,ornamental,patterned"},
    {WordKind::pattern, "geometric", "geometric,~polka dot,~zigzag"},
    {WordKind::pattern, "plain", "plain,solid"},

    {WordKind::time, "morning", "morning,sunrise,dawn,early morning"},
    {WordKind::time, "day", "day,daytime,daylight,noon,midday,afternoon"},
    {WordKind::time, "evening", "evening,sunset,golden hour,late afternoon"},
    {WordKind::time, "dusk", "dusk,twilight,blue hour,nightfall"},
    {WordKind::time, "night", "night,nighttime,midnight,at night,moonlit,~moonlight"},

    {WordKind::weather, "sunny", "sunny,sunlit,sun,sunlight,sunshine,clear sky,sun drenched,sun filled,~summer"},
    {WordKind::weather, "overcast", "overcast,cloudy,gray sky,foggy,misty,~autumn"},
    {WordKind::weather, "rainy", "rainy,rain,stormy,~snowy,~snow,~winter"},

    {WordKind::light, "lamps on", "lamp light,lamplight,lamplit,candlelight,candlelit,lights on,ambient lighting,~neon,lit lamps,~firelight"},
    {WordKind::light, "bright", "bright,well lit,light filled,brightly lit,luminous,natural light,light flooded"},
    {WordKind::light, "dim", "dim,dark,moody,dimly lit,shadowy,gloomy,~dramatic"},

    {WordKind::size, "large", "large,big,huge,tall,wide,oversized,floor to ceiling,long,massive,panoramic,grand"},
    {WordKind::size, "small", "small,little,tiny,compact,narrow,mini,low"},
    {WordKind::size, "spacious", "spacious,roomy,vast,expansive,open"},

    {WordKind::mood, "cozy", "cozy,cosy,warm,snug,homely,inviting,comfy,comfortable,romantic,intimate,welcoming,homey,~relaxing"},
    {WordKind::mood, "airy", "airy,fresh,light,breezy,calm,serene,peaceful,tranquil,quiet"},
    {WordKind::mood, "cluttered", "cluttered,messy,lived in,crowded,full"},
    {WordKind::mood, "bare", "bare,empty,tidy,uncluttered,sparse,simple,neat"},
    {WordKind::mood, "colorful", "colorful,colourful,vibrant,playful,cheerful,lively"},

    {WordKind::count, "1", "a,an,one,single,the,1"},
    {WordKind::count, "2", "two,pair of,couple of,twin,pair"},
    {WordKind::count, "3", "three,several,some,few,a few"},
    {WordKind::count, "4", "four,many,lots of,multiple,various"},
    {WordKind::count, "5", "five"},
    {WordKind::count, "6", "six,half a dozen"},
    {WordKind::count, "7", "seven"},
    {WordKind::count, "8", "eight"},
    {WordKind::count, "9", "nine"},
    {WordKind::count, "10", "ten"},
    {WordKind::count, "11", "eleven"},
    {WordKind::count, "12", "twelve,dozen,a dozen"},
    {WordKind::count, "15", "fifteen"},
    {WordKind::count, "20", "twenty"},

    {WordKind::negation, "no", "no,without,not,minus,free of,lacking"},

    {WordKind::relation, "under", "under,below,beneath,underneath"},
    {WordKind::relation, "next to", "next to,beside,near,by,alongside,close to,adjacent to,by the"},
    {WordKind::relation, "on", "on,on top of,atop,upon"},
    {WordKind::relation, "above", "above,over"},
    {WordKind::relation, "in front of", "in front of,facing,opposite,before,across from"},
    {WordKind::relation, "behind", "behind,at the back of"},
    {WordKind::relation, "in the corner", "in the corner,in a corner,corner,in one corner"},
    {WordKind::relation, "around", "around"},
    {WordKind::relation, "between", "between"},

    {WordKind::stop, "", "and,with,in,of,at,to,for,from,that,which,is,are,has,have,having,there,it,its,this,room,interior,scene,space,style,styled,"
                         "design,designed,decor,decorated,decoration,furnished,furniture,featuring,features,view,very,really,quite,beautiful,nice,pretty,lovely,stylish,gorgeous,"
                         "photo,photorealistic,realistic,image,render,3d,360,panorama,panoramic view,indoor,inside,home,house,please,make,me,my,create,generate,i,want,would,like,"
                         "show,set,side,against,into,through,covered,made,filled,full of,or,but,also,plus,as,where,while,color,colored,coloured,toned,tone,tones,theme,themed,accents,accent,touches,"
                         "light wood,hanging,standing,old,new,fancy,soft,fluffy,perfect,high,quality,detailed,4k,8k,hd,lighting,looking,look,overlooking,coming,shining,streaming,matching,"
                         "upper,lower,left,right,center,middle,centre,front,back,all,each,every,other,another,both,wall mounted,mounted,built,built in"},
};

std::string without_mark(std::string_view term) { return std::string(term.starts_with('~') ? term.substr(1) : term); }

const std::map<std::string, Word>& table() {
    static const std::map<std::string, Word> words = [] {
        std::map<std::string, Word> out;
        for (const Line& line : kLines)
            for (std::string_view rest = line.terms; !rest.empty();) {
                const std::size_t comma = rest.find(',');
                const std::string_view term = rest.substr(0, comma);
                out.emplace(without_mark(term), Word{line.kind, line.meaning, !term.starts_with('~')});
                rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 1);
            }
        return out;
    }();
    return words;
}

// English plurals, last word only: shelves, glasses, bodies, chairs.
std::vector<std::string> singulars(const std::string& term) {
    std::vector<std::string> out;
    const auto ends = [&](std::string_view e) { return term.size() > e.size() + 1 && term.ends_with(e); };
    if (ends("ves")) out.push_back(term.substr(0, term.size() - 3) + "f");
    if (ends("ies")) out.push_back(term.substr(0, term.size() - 3) + "y");
    if (ends("es")) out.push_back(term.substr(0, term.size() - 2));
    if (ends("s")) out.push_back(term.substr(0, term.size() - 1));
    return out;
}

// Damerau-Levenshtein distance of at most one.
bool within_one(std::string_view a, std::string_view b) {
    if (a.size() > b.size()) std::swap(a, b);
    if (b.size() - a.size() > 1) return false;
    std::size_t i = 0;
    while (i < a.size() && a[i] == b[i]) ++i;
    if (a.size() < b.size()) return a.substr(i) == b.substr(i + 1);
    if (i == a.size()) return true;
    if (a.substr(i + 1) == b.substr(i + 1)) return true;
    return i + 1 < a.size() && a[i] == b[i + 1] && a[i + 1] == b[i] && a.substr(i + 2) == b.substr(i + 2);
}

}  // namespace

std::optional<Word> look_up(const std::string& term) {
    const auto find = [](const std::string& t) -> std::optional<Word> {
        if (const auto at = table().find(t); at != table().end()) return at->second;
        // Digits; more than 99 of a thing is no room.
        if (t.size() <= 2 && t[0] >= '1' && t[0] <= '9' && std::all_of(t.begin(), t.end(), [](char c) { return c >= '0' && c <= '9'; })) return Word{WordKind::count, t, true};
        if (color_named(t)) return Word{WordKind::color, t, true};
        return {};
    };
    if (const auto word = find(term)) return word;
    for (const std::string& singular : singulars(term))
        if (const auto word = find(singular); word && word->kind != WordKind::stop && word->kind != WordKind::count) return word;
    return {};
}

std::optional<std::string> nearest_term(const std::string& word) {
    if (word.size() < 5) return {};
    std::optional<std::string> best;
    for (const auto& [term, meaning] : table()) {
        if (term.size() < 5 || meaning.kind == WordKind::stop || !within_one(word, term)) continue;
        if (best && look_up(*best)->meaning != meaning.meaning) return {};  // two meanings are as near: do not guess
        if (!best) best = term;
    }
    return best;
}

std::string room_title(std::string_view room) {
    if (room == "living") return "living room";
    if (room == "kids") return "kids' room";
    if (room == "dining") return "dining room";
    if (room == "laundry") return "laundry room";
    return std::string(room);
}

std::vector<std::string> room_types() {
    return {"living", "bedroom", "kids", "kitchen", "dining", "bathroom", "study", "hallway", "loft", "laundry", "sunroom", "attic"};
}

std::size_t lexicon_size() { return table().size(); }

std::vector<std::string> lexicon_terms() {
    std::vector<std::string> out;
    for (const auto& [term, word] : table()) out.push_back(term);
    return out;
}

}  // namespace fastscene
