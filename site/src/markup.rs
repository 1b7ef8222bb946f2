//! HTML: escaped text, and the frame of a page.

/// Text in which nothing is a tag.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// A page of the site; `root` leads from its folder to the first page.
pub(crate) fn page(root: &str, title: &str, content: &str) -> String {
    let title = escaped(title);
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title} · lagrangian</title>\n\
         <link rel=\"icon\" href=\"data:,\">\n<link rel=\"stylesheet\" href=\"{root}style.css\">\n\
         <link rel=\"stylesheet\" href=\"{root}figures.css\">\n</head>\n<body>\n<header>\n  \
         <a class=\"brand\" href=\"{root}index.html\">lagrangian</a>\n  <nav aria-label=\"Site\">\
         <a href=\"{root}index.html\">Gallery</a><a href=\"{root}play.html\">Play</a></nav>\n</header>\n<main>\n{content}</main>\n\
         <footer><p>Written by <code>cargo run --release -p lagrangian-site</code> from the declarations of the models.</p></footer>\n\
         </body>\n</html>\n"
    )
}
