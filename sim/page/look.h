// look.h - the page's style sheet and its script
#pragma once

namespace sim::page {

inline constexpr const char* STYLE = R"(
:root{color-scheme:light dark;--back:#fff;--text:#1c1e21;--soft:#667;--rule:#ccd;--box:#f4f5f8;
--good:#167a3c;--bad:#c0262d;--blue:#2b62c4;--warm:#b86a00}
@media(prefers-color-scheme:dark){:root{--back:#14161a;--text:#e4e6ea;--soft:#9aa3b2;--rule:#3a404c;
--box:#1e2229;--good:#4cc27a;--bad:#ff6b6b;--blue:#7aa7ff;--warm:#f0a94a}}
body{background:var(--back);color:var(--text);font:15px/1.5 system-ui,sans-serif;max-width:1100px;
margin:0 auto;padding:1em}
h1{margin:.2em 0}h2{margin:1.6em 0 .4em;border-bottom:1px solid var(--rule)}
a{color:var(--blue)}pre,code{font:13px/1.4 ui-monospace,monospace}
.verdict{display:inline-block;padding:.1em .6em;border-radius:4px;
color:var(--back);font-weight:bold;
background:var(--good)}.verdict.failed{background:var(--bad)}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.1em 1em}dt{color:var(--soft)}dd{margin:0;
white-space:pre-wrap}
svg{width:100%;height:auto;display:block;font:11px system-ui,sans-serif}
.grid{stroke:var(--rule);stroke-width:1}.mark{fill:var(--soft);text-anchor:middle}
.name{fill:var(--soft);text-anchor:end}.label{fill:var(--text)}
.action{fill:var(--soft)}.good{fill:var(--good)}.bad{fill:var(--bad)}
.lit{fill:var(--blue);fill-opacity:.3;stroke:var(--back)}.dark{fill:var(--box);stroke:var(--back)}
.sound{fill:var(--blue)}.line{fill:none;stroke:var(--blue)}.busy{stroke:var(--good)}
.bus{stroke:var(--warm)}.key{display:inline-block;width:1.4em;height:3px;vertical-align:middle}
table{border-collapse:collapse;width:100%}
td,th{text-align:left;vertical-align:top;padding:.15em .6em;
border-bottom:1px solid var(--rule)}td:nth-child(3){width:40%}
td{white-space:pre-wrap}td.time{white-space:nowrap;color:var(--soft);text-align:right}
tr.met .mark-of::before{content:"\2713";color:var(--good)}
tr.missed .mark-of::before{content:"\2717";color:var(--bad)}tr.missed{background:var(--box)}
tr:target,figure:target{outline:2px solid var(--blue)}
figure{margin:0}figcaption{color:var(--soft);font-size:12px}
.strip{display:flex;gap:6px;overflow-x:auto;padding:4px 0}
.strip figure{flex:none}.strip img{height:120px;width:auto;display:block;background:#000}
.mark-of{white-space:nowrap}figure:has([data-what=expected]){order:-1}
.three{white-space:normal;align-items:start;display:grid;
grid-template-columns:repeat(3,minmax(0,1fr));gap:6px;margin:.4em 0;overflow-wrap:anywhere}
.three img,.wipe img,.large img{width:100%;display:block;image-rendering:pixelated;background:#000}
.wipe,.large{max-width:640px;margin:.4em 0}.over{position:relative}
.over img+img{position:absolute;inset:0;clip-path:inset(0 0 0 50%)}
input[type=range]{width:100%}
pre{background:var(--box);padding:.6em;overflow-x:auto;white-space:pre-wrap;word-break:break-word}
.scroll{max-height:30em;overflow-y:auto}
)";

// A golden picture and what there was instead, one over the other, and the strip as a film.
inline constexpr const char* SCRIPT = R"(
const make=(name,parent,more)=>parent.appendChild(Object.assign(document.createElement(name),more));
for(const three of document.querySelectorAll('.three')){
  const of=what=>three.querySelector('[data-what='+what+']');
  if(!of('expected')||!of('actual'))continue;
  const wipe=make('div',three.parentNode,{className:'wipe'}),
    over=make('div',wipe,{className:'over'});
  over.append(of('expected').cloneNode(),of('actual').cloneNode());
  const slider=make('input',wipe,{type:'range',max:100,value:50,ariaLabel:'expected or actual'});
  slider.oninput=()=>over.lastChild.style.clipPath='inset(0 0 0 '+slider.value+'%)';
  make('small',wipe,{textContent:'left of the slider expected, right of it actual'});
}
const film=[...document.querySelectorAll('.strip figure')];
if(film.length){
  const large=document.createElement('div');large.className='large';
  document.querySelector('.strip').before(large);
  const picture=make('img',large,{alt:''}),text=make('div',large);
  const slider=make('input',large,{type:'range',max:film.length-1,value:film.length-1,
    ariaLabel:'picture'});
  const show=i=>{slider.value=i;picture.src=film[i].querySelector('img').src;
    text.textContent=film[i].textContent};
  slider.oninput=()=>show(slider.value);
  film.forEach((figure,i)=>figure.onclick=()=>show(i));
  addEventListener('hashchange',()=>{
    const i=film.findIndex(figure=>'#'+figure.id==location.hash);if(i>=0)show(i)});
  show(film.length-1);
}
)";

}  // namespace sim::page
