"""The preprocessor, from characters to lexemes. Others import it from here."""

from shadercache.front.preprocess.reader import Preprocessed as Preprocessed
from shadercache.front.preprocess.reader import preprocess as preprocess
from shadercache.front.preprocess.reader import preprocess_broken as preprocess_broken
from shadercache.front.preprocess.scanner import MAX_WORD as MAX_WORD
from shadercache.front.preprocess.scanner import Lexemes as Lexemes
from shadercache.front.preprocess.scanner import clean as clean
from shadercache.front.preprocess.scanner import is_number as is_number
from shadercache.front.preprocess.scanner import is_word as is_word
from shadercache.front.preprocess.scanner import spellings as spellings
from shadercache.front.preprocess.version import NO_VERSION as NO_VERSION
from shadercache.front.preprocess.version import Version as Version
from shadercache.front.preprocess.version import enabled_extensions as enabled_extensions
from shadercache.front.preprocess.version import joins_comments as joins_comments
from shadercache.front.preprocess.version import read_version as read_version
from shadercache.front.preprocess.version import version_line as version_line
from shadercache.front.preprocess.version import written_lines as written_lines
